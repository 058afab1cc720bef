#pragma once

// OpenGL as libOSMesa exports it, and the few handles that the renderer owns.
#define GL_GLEXT_PROTOTYPES
#include <GL/osmesa.h>
// osmesa.h includes gl.h; glext.h holds what came after OpenGL 1.3.
#include <GL/glext.h>

namespace palpate::sim {

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
