#include "sim/view/renderer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <stdexcept>

#include "sim/view/corners.hpp"
#include "sim/view/gl.hpp"
#include "sim/view/scale_bar.hpp"

namespace palpate::sim {
namespace {

constexpr int kSamples = 4;  // of each pixel, for smooth outlines

OSMesaContext make_context() {
  load_gl();
  return OSMesaCreateContextExt(OSMESA_RGBA, 0, 0, 0, nullptr);
}

struct OsMesa {
  OSMesaContext context = make_context();
  std::array<std::uint8_t, 4> pixel{};  // OSMesa wants a buffer of its own; the pictures have others
  OsMesa() {
    if (context == nullptr) throw std::runtime_error("OSMesa cannot make an OpenGL context (libosmesa6)");
    make_current();
  }
  ~OsMesa() { OSMesaDestroyContext(context); }
  OsMesa(const OsMesa&) = delete;
  OsMesa& operator=(const OsMesa&) = delete;
  void make_current() {
    if (OSMesaMakeCurrent(context, pixel.data(), GL_UNSIGNED_BYTE, 1, 1) != GL_TRUE)
      throw std::runtime_error("OSMesa cannot make its OpenGL context current");
  }
};

void set_projection(const Camera& camera, double aspect, const Corners& corners) {
  double nearest = INFINITY, farthest = 0;
  for (const std::vector<Corner>* list : {&corners.opaque, &corners.translucent}) {
    for (const Corner& corner : *list) {
      nearest = std::min(nearest, -static_cast<double>(corner.position.z()));
      farthest = std::max(farthest, -static_cast<double>(corner.position.z()));
    }
  }
  const double distance = (camera.eye - camera.target).norm();
  const double near = std::max(0.99 * std::min(nearest, distance), 0.01 * distance);
  const double far = std::max(1.01 * farthest, 1.5 * near);
  const double top = near * std::tan(camera.field_of_view / 2);
  glMatrixMode(GL_PROJECTION);
  glLoadIdentity();
  glFrustum(-top * aspect, top * aspect, -top, top, near, far);
}

void draw(const std::vector<Corner>& corners) {
  if (corners.empty()) return;
  const auto attribute = [&](GLuint index, GLint size, const float* first) {
    glEnableVertexAttribArray(index);
    glVertexAttribPointer(index, size, GL_FLOAT, GL_FALSE, sizeof(Corner), first);
  };
  attribute(kPosition, 3, corners.front().position.data());
  attribute(kNormal, 3, corners.front().normal.data());
  attribute(kColour, 4, corners.front().colour.data());
  attribute(kEdge, 3, corners.front().edge.data());
  glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(corners.size()));
}

void draw_scale_bar(const Picture& picture, int height) {
  const ScaleBar bar = scale_bar_of(picture, height);
  const int line = bar.thickness, tick = 2 * line;
  const auto fill = [](int x, int y, int width, int high) {
    glScissor(x, y, width, high);
    glClear(GL_COLOR_BUFFER_BIT);
  };
  glEnable(GL_SCISSOR_TEST);
  glClearColor(0.25F, 0.25F, 0.27F, 1.0F);
  fill(bar.left, bar.bottom, bar.length, line);
  fill(bar.left, bar.bottom - tick, line, line + 2 * tick);
  fill(bar.left + bar.length - line, bar.bottom - tick, line, line + 2 * tick);
  glDisable(GL_SCISSOR_TEST);
}

}  // namespace

struct Renderer::Context {
  int width, height;
  OsMesa osmesa{};
  GLuint program = 0;
  Target drawn{};     // several samples a pixel
  Target resolved{};  // their mean
};

Renderer::Renderer(int width, int height) {
  if (width < 16 || height < 16 || width > 8192 || height > 8192)
    throw std::invalid_argument(
        fmt::format("a picture of {} x {} pixels: each side must be 16 to 8192", width, height));
  context_.reset(new Context{.width = width, .height = height});
  context_->program = make_program();
  context_->drawn = make_target(width, height, kSamples);
  context_->resolved = make_target(width, height, 0);
  check_gl("setting up the picture");
}

Renderer::~Renderer() = default;

Image Renderer::render(const Picture& picture) {
  const int width = context_->width, height = context_->height;
  const Corners corners = corners_of(picture);
  context_->osmesa.make_current();
  glBindFramebuffer(GL_FRAMEBUFFER, context_->drawn.frame);
  glViewport(0, 0, width, height);
  glClearColor(picture.background.red, picture.background.green, picture.background.blue, 1.0F);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  glUseProgram(context_->program);
  set_projection(picture.camera, static_cast<double>(width) / height, corners);

  glEnable(GL_DEPTH_TEST);
  draw(corners.opaque);
  glEnable(GL_BLEND);
  glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  glDepthMask(GL_FALSE);
  draw(corners.translucent);
  glDepthMask(GL_TRUE);
  glDisable(GL_BLEND);
  if (picture.scale_bar > 0) draw_scale_bar(picture, height);

  glBindFramebuffer(GL_READ_FRAMEBUFFER, context_->drawn.frame);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, context_->resolved.frame);
  glBlitFramebuffer(0, 0, width, height, 0, 0, width, height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, context_->resolved.frame);
  const std::size_t row = 3 * static_cast<std::size_t>(width);
  std::vector<std::uint8_t> upside_down(row * static_cast<std::size_t>(height));
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, width, height, GL_RGB, GL_UNSIGNED_BYTE, upside_down.data());
  check_gl("drawing a picture");

  Image image{.width = width, .height = height, .rgb = std::vector<std::uint8_t>(upside_down.size())};
  for (std::size_t y = 0; y < static_cast<std::size_t>(height); ++y)
    std::copy_n(&upside_down[(height - 1 - y) * row], row, &image.rgb[y * row]);
  return image;
}

}  // namespace palpate::sim
