#pragma once

#include <vector>

#include "sim/cycle/cycle.hpp"
#include "sim/scene/model.hpp"
#include "sim/view/picture.hpp"

namespace palpate::sim {

/// What stays the same in all pictures of a model, so that they can be compared and put in a row.
struct Stage {
  Camera camera{};            // frames the bodies at rest, looks across the press and into what is hollow
  std::vector<Vec3> shafts;   // of each probe: towards the hand, where the bodies leave most room
  std::vector<double> radii;  // of each probe as drawn [m]
  double scale_bar = 0.0;     // a round length, about a tenth of the picture's width [m]
};
Stage set_stage(const Model& model);

/// The bodies deformed by the loads of a cycle, and the probes where the pose holds them.
Picture picture_of(const Model& model, const Stage& stage, const Loads& loads, Pose pose);

}  // namespace palpate::sim
