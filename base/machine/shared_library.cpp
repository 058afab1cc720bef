#include "base/machine/shared_library.hpp"

#include <dlfcn.h>
#include <fmt/format.h>

#include <stdexcept>

namespace palpate::base {

SharedLibrary::SharedLibrary(const char* file, const char* package, const char* without)
    : file_(file), without_(without), library_(::dlopen(file, RTLD_NOW | RTLD_LOCAL)) {
  if (library_ == nullptr)
    throw std::runtime_error(
        fmt::format("{}: {} cannot be loaded ({}); it is in the package {}", without, file, ::dlerror(),
                    package));  // NOLINT(concurrency-mt-unsafe): glibc keeps one a thread
}

void* SharedLibrary::address(const char* name) const {
  void* found = ::dlsym(library_, name);
  if (found == nullptr) throw std::runtime_error(fmt::format("{}: {} has no {}", without_, file_, name));
  return found;
}

}  // namespace palpate::base
