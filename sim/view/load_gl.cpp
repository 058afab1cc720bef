#include "base/machine/shared_library.hpp"
#include "sim/view/gl.hpp"

namespace palpate::sim {

// NOLINTNEXTLINE(bugprone-macro-parentheses): a name that is declared takes none
#define PALPATE_GL(name) decltype(&::name) name = nullptr;
PALPATE_GL_FUNCTIONS
#undef PALPATE_GL

namespace {

bool load_all() {
  const base::SharedLibrary library("libOSMesa.so.8", "libosmesa6", "nothing can be drawn");
#define PALPATE_GL(name) library.find(#name, name);
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
