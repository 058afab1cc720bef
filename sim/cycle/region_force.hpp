#pragma once

#include "sim/model/loads.hpp"
#include "sim/model/model.hpp"

namespace palpate::sim {

/// Adds the force and the torque of a probe that holds a region, from the loads of the response: what the motion of
/// the body's regions takes, less what the loads on the body's nodes do by themselves (reciprocity: the work of the
/// loads along the motion that the region brings). The torque is about where the region's centre has come.
void add_region_force(const Model& model, int probe, Response& response);

}  // namespace palpate::sim
