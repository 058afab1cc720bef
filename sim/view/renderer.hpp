#pragma once

#include <memory>

#include "sim/view/image.hpp"
#include "sim/view/picture.hpp"

namespace palpate::sim {

/// Draws pictures in memory with OSMesa: no screen, no graphics card. Owns an OpenGL context, so make and use
/// it on one thread.
class Renderer {
 public:
  /// @param width, height  of every picture [pixel], 16 to 8192
  /// Throws std::invalid_argument for a size out of these bounds, std::runtime_error when OpenGL refuses.
  Renderer(int width, int height);
  ~Renderer();
  Renderer(const Renderer&) = delete;
  Renderer& operator=(const Renderer&) = delete;

  /// Anti-aliased; translucent surfaces are blended from far to near whatever the order of the triangles.
  /// The same picture gives the same bits.
  Image render(const Picture& picture);

 private:
  struct Context;
  std::unique_ptr<Context> context_;
};

}  // namespace palpate::sim
