#pragma once

#include "sim/mesh/tet_mesh.hpp"
#include "sim/scene/scene.hpp"

namespace palpate::sim {

/// The mesh of a body, validated, where scale, rotate and offset put it. Throws std::invalid_argument, also
/// where they take it to where numbers have no meaning left.
TetMesh read_placed(const BodySpec& spec);

}  // namespace palpate::sim
