#pragma once

#include <optional>
#include <vector>

#include "sim/model/free_state.hpp"
#include "sim/model/loads.hpp"
#include "sim/model/model.hpp"
#include "sim/view/picture.hpp"

namespace palpate::sim {

/// How a probe is drawn, whatever its pose.
struct ProbeShape {
  Vec3 shaft = -Vec3::UnitZ();  // towards the hand, where the bodies at rest leave room, unit length
  double radius = 0.0;          // [m]
  double length = 0.0;          // [m]
};

/// What stays the same in all pictures of a model, so that they can be compared and put in a row.
struct Stage {
  /// Frames the bodies at rest; looks across the press and, from above, along the first shaft.
  Camera camera{};
  std::vector<ProbeShape> probes{};  // in the model's order
  double scale_bar = 0.0;            // a round length, about an eighth of the picture's width [m]
};

/// From where a picture is seen.
struct ViewPoint {
  double azimuth =
      0.0;  // around the z axis: 0 from the front (from -y), a quarter turn from the right (+x) [rad]
  double elevation = 0.0;  // above the xy plane: a quarter turn from the top [rad]
};

/// @param aspect  width of the pictures over their height
/// @param from  nothing: across the press
Stage set_stage(const Model& model, double aspect, const std::optional<ViewPoint>& from = {});

/// The bodies deformed by the loads of a cycle, and the probes where they are. A body that is
/// pressed by a probe while there are others is translucent, for the others lie behind it.
Picture picture_of(const Model& model, const Stage& stage, const Loads& loads, ProbeDisplacements probes);

}  // namespace palpate::sim
