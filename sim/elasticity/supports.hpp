#pragma once

#include <Eigen/SparseCore>
#include <span>
#include <vector>

#include "sim/mesh/tet_mesh.hpp"

namespace palpate::sim {

/// Which nodes a stiffness joins: the neighbours of node i are neighbour[begin[i] .. begin[i + 1]),
/// ascending, i itself not among them.
struct NodeGraph {
  std::vector<int> begin;
  std::vector<int> neighbour;
  int nodes() const { return static_cast<int>(begin.size()) - 1; }
};

/// @param K  3n x 3n, unknowns x y z of each node
NodeGraph node_graph(const Eigen::SparseMatrix<double>& K);

/// The pieces that hang together: piece number of each node, counted from 0 in the order of their first
/// nodes.
std::vector<int> connected_pieces(const NodeGraph& graph);

/// Refuses supports that leave a rigid motion of any piece, as far as their number alone tells: one fixed
/// node holds 3 of 6 motions, two hold 5. Three and more on one line hold 5 too; where they lie a stiffness
/// does not tell, so that is found by require_supports(mesh, fixed), or else by the factorisation.
/// @param fixed  ascending
/// Throws std::invalid_argument that names the piece and the rank that is missing.
void require_supports(const NodeGraph& graph, std::span<const int> fixed);

/// The same, complete: the rank of the 6 rigid motions restricted to the fixed nodes of each piece of the
/// mesh.
void require_supports(const TetMesh& mesh, std::span<const int> fixed);

}  // namespace palpate::sim
