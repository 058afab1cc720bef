#pragma once

// What is called of OpenGL and OSMesa, once for each: PALPATE_GL(name).
#define PALPATE_GL_FUNCTIONS                   \
  PALPATE_GL(OSMesaCreateContextExt)           \
  PALPATE_GL(OSMesaDestroyContext)             \
  PALPATE_GL(OSMesaMakeCurrent)                \
  PALPATE_GL(glAttachShader)                   \
  PALPATE_GL(glBindAttribLocation)             \
  PALPATE_GL(glBindFramebuffer)                \
  PALPATE_GL(glBindRenderbuffer)               \
  PALPATE_GL(glBlendFunc)                      \
  PALPATE_GL(glBlitFramebuffer)                \
  PALPATE_GL(glCheckFramebufferStatus)         \
  PALPATE_GL(glClear)                          \
  PALPATE_GL(glClearColor)                     \
  PALPATE_GL(glCompileShader)                  \
  PALPATE_GL(glCreateProgram)                  \
  PALPATE_GL(glCreateShader)                   \
  PALPATE_GL(glDepthMask)                      \
  PALPATE_GL(glDisable)                        \
  PALPATE_GL(glDrawArrays)                     \
  PALPATE_GL(glEnable)                         \
  PALPATE_GL(glEnableVertexAttribArray)        \
  PALPATE_GL(glFramebufferRenderbuffer)        \
  PALPATE_GL(glFrustum)                        \
  PALPATE_GL(glGenFramebuffers)                \
  PALPATE_GL(glGenRenderbuffers)               \
  PALPATE_GL(glGetError)                       \
  PALPATE_GL(glGetProgramiv)                   \
  PALPATE_GL(glGetShaderInfoLog)               \
  PALPATE_GL(glGetShaderiv)                    \
  PALPATE_GL(glLinkProgram)                    \
  PALPATE_GL(glLoadIdentity)                   \
  PALPATE_GL(glMatrixMode)                     \
  PALPATE_GL(glPixelStorei)                    \
  PALPATE_GL(glReadPixels)                     \
  PALPATE_GL(glRenderbufferStorageMultisample) \
  PALPATE_GL(glScissor)                        \
  PALPATE_GL(glShaderSource)                   \
  PALPATE_GL(glUseProgram)                     \
  PALPATE_GL(glVertexAttribPointer)            \
  PALPATE_GL(glViewport)
