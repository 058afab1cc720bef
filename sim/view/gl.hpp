#pragma once

// OpenGL as libOSMesa exports it, and the few handles that the renderer owns. The library, and LLVM with it, is
// loaded when something is drawn: a statistic needs neither.
#define GL_GLEXT_PROTOTYPES
#include <GL/osmesa.h>
// osmesa.h includes gl.h; glext.h holds what came after OpenGL 1.3.
#include <GL/glext.h>

#include "sim/view/gl_functions.hpp"

namespace palpate::sim {

// Within this namespace OpenGL's names are these pointers, so that a call reads as it always does.
// NOLINTNEXTLINE(bugprone-macro-parentheses): a name that is declared takes none
#define PALPATE_GL(name) extern decltype(&::name) name;
PALPATE_GL_FUNCTIONS
#undef PALPATE_GL

/// Loads libOSMesa, unless it is there already; before any other call. Throws std::runtime_error that names
/// the package where it cannot be had.
void load_gl();

/// Throws std::runtime_error that says what was being done if OpenGL reports an error.
void check_gl(const char* doing);

/// The shaders compiled and linked, their attributes at the places that the renderer gives them.
/// Throws std::runtime_error with the compiler's words.
GLuint make_program();

enum Attribute : GLuint { kPosition = 0, kNormal = 1, kColour = 2, kEdge = 3 };

/// Colour and depth to draw into, in memory.
struct Target {
  GLuint frame = 0, colour = 0, depth = 0;
};
/// @param samples  of each pixel, 0 for one without anti-aliasing
Target make_target(int width, int height, int samples);

}  // namespace palpate::sim
