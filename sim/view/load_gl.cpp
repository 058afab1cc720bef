#include <dlfcn.h>
#include <fmt/format.h>

#include <stdexcept>

#include "sim/view/gl.hpp"

namespace palpate::sim {

// NOLINTNEXTLINE(bugprone-macro-parentheses): a name that is declared takes none
#define PALPATE_GL(name) decltype(&::name) name = nullptr;
PALPATE_GL_FUNCTIONS
#undef PALPATE_GL

namespace {

constexpr const char* kLibrary = "libOSMesa.so.8";

void* open_library() {
  void* library = ::dlopen(kLibrary, RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr)
    throw std::runtime_error(
        fmt::format("nothing can be drawn: {} cannot be loaded ({}); it is in the package libosmesa6",
                    kLibrary, ::dlerror()));  // NOLINT(concurrency-mt-unsafe): glibc keeps one a thread
  return library;
}

template <class Function>
void find(void* library, const char* name, Function& function) {
  function = reinterpret_cast<Function>(::dlsym(library, name));
  if (function == nullptr)
    throw std::runtime_error(fmt::format("nothing can be drawn: {} has no {}", kLibrary, name));
}

bool load_all() {
  void* library = open_library();
#define PALPATE_GL(name) find(library, #name, name);
  PALPATE_GL_FUNCTIONS
#undef PALPATE_GL
  return true;
}

}  // namespace

void load_gl() {
  static const bool loaded = load_all();  // once, whichever thread draws first
  static_cast<void>(loaded);
}

}  // namespace palpate::sim
