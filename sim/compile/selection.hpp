#pragma once

#include <string>
#include <vector>

#include "sim/elasticity/stiffness.hpp"
#include "sim/mesh/surface.hpp"
#include "sim/mesh/tet_mesh.hpp"
#include "sim/scene/scene.hpp"

namespace palpate::sim {

/// The nodes of a mesh that a scene's key selects, ascending. Throws std::invalid_argument "KEY: ..." where
/// the mesh lacks what is named, or nothing is selected.
std::vector<int> select(const TetMesh& mesh, const NodeSelection& selection, const std::string& key);

/// The materials of a body's volume groups, as stiffness() takes them.
std::vector<Material> materials_of(const BodySpec& spec, const TetMesh& mesh);

/// `nodes` without those of `left_out`; all ascending.
std::vector<int> without(const std::vector<int>& nodes, const std::vector<int>& left_out);

/// The surface nodes that may touch another body: the scene's group, or the whole free surface.
std::vector<int> colliding_nodes(const BodySpec& spec, const TetMesh& mesh, const Surface& surface,
                                 const std::vector<int>& fixed);

}  // namespace palpate::sim
