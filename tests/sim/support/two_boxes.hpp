#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "sim/model/model.hpp"

namespace palpate::sim::test {

/// Two boxes one above the other with a gap between, as a scene on disk: the upper one ("upper") is held at
/// its sides and pressed down by a probe in the middle of its top; the lower one ("lower") stands on its
/// fixed bottom.
struct TwoBoxes {
  int divisions = 6;        // of the lower box along x and y
  int upper_divisions = 6;  // of the upper box
  double gap = 0.2e-3;      // [m]
  double shift = 0.0;       // of the upper box along x and y [m], so that nodes need not face nodes
  std::string probe = "kind = \"point\"";
  bool second_probe = false;  // "thumb", a point on the lower box's top, beside the middle
};

/// Writes meshes and scene into a fresh folder and gives the scene's path. The folder goes with the process's
/// end.
std::filesystem::path write_two_boxes(const TwoBoxes& boxes = {});

/// Compiles a scene with a cache in memory only.
Model compile_scene(const std::filesystem::path& scene, std::span<const Override> overrides = {});

}  // namespace palpate::sim::test
