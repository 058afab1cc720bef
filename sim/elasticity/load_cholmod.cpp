#include <dlfcn.h>
#include <fmt/format.h>

#include <stdexcept>

#include "sim/elasticity/cholmod.hpp"

namespace palpate::sim {

// NOLINTNEXTLINE(bugprone-macro-parentheses): a name that is declared takes none
#define PALPATE_CHOLMOD(name) decltype(&::name) name = nullptr;
PALPATE_CHOLMOD_FUNCTIONS
#undef PALPATE_CHOLMOD

namespace {

constexpr const char* kLibrary = "libcholmod.so.3";

template <class Function>
void find(void* library, const char* name, Function& function) {
  function = reinterpret_cast<Function>(::dlsym(library, name));
  if (function == nullptr)
    throw std::runtime_error(fmt::format("no body can be condensed: {} has no {}", kLibrary, name));
}

bool load_all() {
  void* library = ::dlopen(kLibrary, RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr)
    throw std::runtime_error(
        fmt::format("no body can be condensed: {} cannot be loaded ({}); it is in the package libcholmod3",
                    kLibrary, ::dlerror()));  // NOLINT(concurrency-mt-unsafe): glibc keeps one a thread
#define PALPATE_CHOLMOD(name) find(library, #name, name);
  PALPATE_CHOLMOD_FUNCTIONS
#undef PALPATE_CHOLMOD
  return true;
}

}  // namespace

void load_cholmod() {
  static const bool loaded = load_all();  // once, whichever thread condenses first
  static_cast<void>(loaded);
}

}  // namespace palpate::sim
