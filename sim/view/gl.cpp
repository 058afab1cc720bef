#include "sim/view/gl.hpp"

#include <fmt/format.h>

#include <stdexcept>
#include <string>

#include "sim/view/shaders.hpp"

namespace palpate::sim {
namespace {

GLuint compile_shader(GLenum kind, const char* source) {
  const GLuint shader = glCreateShader(kind);
  glShaderSource(shader, 1, &source, nullptr);
  glCompileShader(shader);
  GLint compiled = GL_FALSE;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
  if (compiled == GL_TRUE) return shader;
  std::string log(1024, '\0');
  glGetShaderInfoLog(shader, static_cast<GLsizei>(log.size()), nullptr, log.data());
  throw std::runtime_error(fmt::format("OpenGL refuses a shader: {}", log.c_str()));
}

}  // namespace

void check_gl(const char* doing) {
  if (const GLenum error = glGetError(); error != GL_NO_ERROR)
    throw std::runtime_error(fmt::format("OpenGL error {:#06x} while {}", error, doing));
}

GLuint make_program() {
  const GLuint program = glCreateProgram();
  glAttachShader(program, compile_shader(GL_VERTEX_SHADER, kVertexShader));
  glAttachShader(program, compile_shader(GL_FRAGMENT_SHADER, kFragmentShader));
  glBindAttribLocation(program, kPosition, "position");
  glBindAttribLocation(program, kNormal, "normal");
  glBindAttribLocation(program, kColour, "colour");
  glBindAttribLocation(program, kEdge, "edge");
  glLinkProgram(program);
  GLint linked = GL_FALSE;
  glGetProgramiv(program, GL_LINK_STATUS, &linked);
  if (linked != GL_TRUE) throw std::runtime_error("OpenGL cannot link the shaders");
  return program;
}

Target make_target(int width, int height, int samples) {
  Target target;
  glGenFramebuffers(1, &target.frame);
  glBindFramebuffer(GL_FRAMEBUFFER, target.frame);
  glGenRenderbuffers(1, &target.colour);
  glBindRenderbuffer(GL_RENDERBUFFER, target.colour);
  glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, GL_RGBA8, width, height);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, target.colour);
  glGenRenderbuffers(1, &target.depth);
  glBindRenderbuffer(GL_RENDERBUFFER, target.depth);
  glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, GL_DEPTH_COMPONENT24, width, height);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, target.depth);
  if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
    throw std::runtime_error(
        fmt::format("OpenGL cannot draw into {} x {} pixels of {} samples", width, height, samples));
  return target;
}

}  // namespace palpate::sim
