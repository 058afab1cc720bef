#pragma once

#include "sim/scene/scene.hpp"

namespace palpate::sim {

/// Whether the meshes that each body names are one body, ever finer. Curved surfaces are cut off by coarse meshes, so
/// that volumes may differ by 15 % and boxes by 5 % of their diagonal.
/// Throws RefusedKey with the mesh and what differs.
void require_one_body(const Scene& scene);

}  // namespace palpate::sim
