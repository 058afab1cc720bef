#include "sim/elasticity/supports.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cassert>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

namespace palpate::sim {
namespace {

struct Piece {
  int first_node = 0;
  int nodes = 0;
  std::vector<int> fixed;
};

/// The pieces of a body and what its file calls the nodes (empty: they are counted from 0).
struct SupportedBody {
  std::vector<Piece> pieces;
  std::span<const std::int64_t> tags;

  std::int64_t name(int node) const { return tags.empty() ? node : tags[node]; }
};

std::vector<Piece> pieces_of(const NodeGraph& graph, std::span<const int> fixed) {
  assert(std::ranges::is_sorted(fixed));
  const std::vector<int> piece_of_node = connected_pieces(graph);
  std::vector<Piece> pieces;
  for (int node = 0; node < graph.nodes(); ++node) {
    const std::size_t piece = piece_of_node[node];
    if (piece == pieces.size()) pieces.push_back({.first_node = node, .nodes = 0, .fixed = {}});
    ++pieces[piece].nodes;
  }
  for (const int node : fixed) pieces[piece_of_node[node]].fixed.push_back(node);
  return pieces;
}

[[noreturn]] void refuse(const SupportedBody& body, const Piece& piece, int free_motions,
                         const std::string& why) {
  const std::string where =
      body.pieces.size() == 1
          ? ""
          : fmt::format(" of one of the body's {} pieces (the one of {} nodes with node {})",
                        body.pieces.size(), piece.nodes, body.name(piece.first_node));
  throw std::invalid_argument(fmt::format(
      "supports leave {} of 6 rigid motions{} free: {}; fix three nodes or more that are not on one line{}",
      free_motions, where, why, body.tags.empty() ? " (nodes are counted from 0)" : ""));
}

void require_enough_nodes(const SupportedBody& body) {
  for (const Piece& piece : body.pieces) {
    const std::vector<int>& fixed = piece.fixed;
    if (static_cast<int>(fixed.size()) == piece.nodes) continue;
    if (fixed.empty()) refuse(body, piece, 6, "no node is fixed");
    if (fixed.size() == 1)
      refuse(body, piece, 3,
             fmt::format("1 fixed node (node {}) holds translations only", body.name(fixed[0])));
    if (fixed.size() == 2)
      refuse(body, piece, 1,
             fmt::format("2 fixed nodes (nodes {} and {}) leave the rotation about the line through them",
                         body.name(fixed[0]), body.name(fixed[1])));
  }
}

/// Whether the nodes lie on one line to within the rounding of their coordinates. The nodes are distinct.
bool on_one_line(const std::vector<Vec3>& at, const std::vector<int>& nodes) {
  const auto place = [&](int node) -> const Vec3& { return at[node]; };
  const Vec3& start = place(nodes[0]);
  const int far = *std::ranges::max_element(nodes, [&](int a, int b) {
    return (place(a) - start).squaredNorm() < (place(b) - start).squaredNorm();
  });
  const Vec3 along = place(far) - start;
  double off_line = 0.0, largest_coordinate = 0.0;
  for (const int node : nodes) {
    off_line = std::max(off_line, along.normalized().cross(place(node) - start).norm());
    largest_coordinate = std::max(largest_coordinate, place(node).cwiseAbs().maxCoeff());
  }
  // Below this a support is a hinge for any purpose: its stiffness is under K's own rounding error.
  return off_line <= 1e-8 * along.norm() + 16 * std::numeric_limits<double>::epsilon() * largest_coordinate;
}

NodeGraph make_graph(int nodes, std::vector<std::pair<int, int>>& edges) {
  std::ranges::sort(edges);
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  NodeGraph graph;
  graph.begin.assign(nodes + 1, 0);
  graph.neighbour.reserve(edges.size());
  for (const auto& [from, to] : edges) {
    ++graph.begin[from + 1];
    graph.neighbour.push_back(to);
  }
  for (std::size_t i = 1; i < graph.begin.size(); ++i) graph.begin[i] += graph.begin[i - 1];
  return graph;
}

}  // namespace

NodeGraph node_graph(const Eigen::SparseMatrix<double>& K) {
  assert(K.rows() == K.cols() && K.cols() % 3 == 0);
  std::vector<std::pair<int, int>> edges;
  for (int column = 0; column < K.outerSize(); ++column)
    for (Eigen::SparseMatrix<double>::InnerIterator entry(K, column); entry; ++entry) {
      const int from = column / 3, to = static_cast<int>(entry.row()) / 3;
      if (from != to && (edges.empty() || edges.back() != std::pair(from, to))) edges.emplace_back(from, to);
    }
  return make_graph(static_cast<int>(K.cols() / 3), edges);
}

std::vector<int> connected_pieces(const NodeGraph& graph) {
  std::vector<int> piece(graph.nodes(), -1), reached;
  int pieces = 0;
  for (int start = 0; start < graph.nodes(); ++start) {
    if (piece[start] >= 0) continue;
    piece[start] = pieces;
    reached.assign(1, start);
    while (!reached.empty()) {
      const std::size_t node = reached.back();
      reached.pop_back();
      for (int k = graph.begin[node]; k < graph.begin[node + 1]; ++k) {
        const int next = graph.neighbour[k];
        if (piece[next] >= 0) continue;
        piece[next] = pieces;
        reached.push_back(next);
      }
    }
    ++pieces;
  }
  return piece;
}

void require_supports(const NodeGraph& graph, std::span<const int> fixed) {
  require_enough_nodes({.pieces = pieces_of(graph, fixed), .tags = {}});
}

void require_supports(const TetMesh& mesh, std::span<const int> fixed) {
  std::vector<std::pair<int, int>> edges;
  for (const Tetrahedron& corners : mesh.tetrahedra)
    for (const int a : corners)
      for (const int b : corners)
        if (a != b) edges.emplace_back(a, b);
  const NodeGraph graph = make_graph(static_cast<int>(mesh.nodes.size()), edges);
  const SupportedBody body{.pieces = pieces_of(graph, fixed), .tags = mesh.node_tags};
  require_enough_nodes(body);
  for (const Piece& piece : body.pieces)
    if (static_cast<int>(piece.fixed.size()) < piece.nodes && on_one_line(mesh.nodes, piece.fixed))
      refuse(body, piece, 1,
             fmt::format("its {} fixed nodes lie on one line and leave the rotation about it",
                         piece.fixed.size()));
}

}  // namespace palpate::sim
