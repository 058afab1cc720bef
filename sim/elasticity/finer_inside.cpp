#include "sim/elasticity/finer_inside.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "sim/mesh/surface.hpp"

namespace palpate::sim {
namespace {

using Edge = std::pair<int, int>;  // ascending

/// How a node of the cut mesh moves: a weighted mean of nodes that are free.
using Follows = std::vector<std::pair<int, double>>;

struct Cut {
  TetMesh mesh{};
  std::vector<Triangle> surface{}, touched{};
  std::vector<Follows> follows{};  // of each node of the mesh
  FinerBody body{};                // its nodes and what they are between
};

std::array<Edge, 3> edges_of(const Triangle& triangle) {
  const auto [a, b, c] = triangle;
  return {std::minmax({a, b}), std::minmax({b, c}), std::minmax({c, a})};
}

std::set<Edge> edges_of(std::span<const Triangle> triangles) {
  std::set<Edge> all;
  for (const Triangle& triangle : triangles)
    for (const Edge& edge : edges_of(triangle)) all.insert(edge);
  return all;
}

Follows mean_of(const Follows& a, const Follows& b) {
  std::map<int, double> sum;
  for (const Follows* end : {&a, &b})
    for (const auto& [node, weight] : *end) sum[node] += 0.5 * weight;
  return {sum.begin(), sum.end()};
}

int free_node(const Follows& follows) {
  return follows.size() == 1 ? follows.front().first : -1;
}

/// The nodes in the middle of every edge.
std::map<Edge, int> add_middles(Cut& cut) {
  const std::set<Edge> touched = edges_of(cut.touched), surface = edges_of(cut.surface);
  std::map<Edge, int> middles;
  for (const Tetrahedron& corners : cut.mesh.tetrahedra)
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = i + 1; j < 4; ++j) middles.try_emplace(std::minmax(corners[i], corners[j]), -1);
  for (auto& [edge, middle] : middles) {
    middle = static_cast<int>(cut.mesh.nodes.size());
    const Vec3 place = 0.5 * (cut.mesh.nodes[edge.first] + cut.mesh.nodes[edge.second]);
    cut.mesh.nodes.push_back(place);
    if (touched.contains(edge)) {
      cut.follows.push_back(mean_of(cut.follows[edge.first], cut.follows[edge.second]));
      continue;
    }
    const int a = free_node(cut.follows[edge.first]), b = free_node(cut.follows[edge.second]);
    const bool on_surface = surface.contains(edge) && a >= 0 && b >= 0;
    cut.follows.push_back({{static_cast<int>(cut.body.nodes.size()), 1.0}});
    cut.body.nodes.push_back(place);
    cut.body.between.push_back(on_surface ? std::array<int, 2>{a, b} : std::array<int, 2>{-1, -1});
  }
  return middles;
}

void push(TetMesh& mesh, Tetrahedron corners, int region) {
  const auto& x = mesh.nodes;
  const Vec3 a = x[corners[1]] - x[corners[0]], b = x[corners[2]] - x[corners[0]],
             c = x[corners[3]] - x[corners[0]];
  if (a.cross(b).dot(c) < 0.0) std::swap(corners[2], corners[3]);
  mesh.tetrahedra.push_back(corners);
  mesh.region.push_back(region);
}

/// Four at the corners; the octahedron that is left becomes four around its shortest diagonal, so that shapes do not
/// get worse from cut to cut. Source: [Bey1995].
void cut_tetrahedra(const std::map<Edge, int>& middles, TetMesh& mesh) {
  const std::vector<Tetrahedron> old = std::exchange(mesh.tetrahedra, {});
  const std::vector<int> regions = std::exchange(mesh.region, {});
  for (std::size_t t = 0; t < old.size(); ++t) {
    const auto& [a, b, c, d] = old[t];
    const auto m = [&](int i, int j) { return middles.at(std::minmax(i, j)); };
    const int ab = m(a, b), ac = m(a, c), ad = m(a, d), bc = m(b, c), bd = m(b, d), cd = m(c, d);
    for (const Tetrahedron& corner :
         {Tetrahedron{a, ab, ac, ad}, {b, ab, bc, bd}, {c, ac, bc, cd}, {d, ad, bd, cd}})
      push(mesh, corner, regions[t]);
    // Opposite corners of the octahedron, each with the ring of the four others.
    const std::array<std::array<int, 6>, 3> diagonals{
        {{ab, cd, ac, bc, bd, ad}, {ac, bd, ab, bc, cd, ad}, {ad, bc, ab, ac, cd, bd}}};
    const auto& [p, q, r0, r1, r2, r3] = *std::ranges::min_element(diagonals, {}, [&](const auto& diagonal) {
      return (mesh.nodes[diagonal[0]] - mesh.nodes[diagonal[1]]).squaredNorm();
    });
    for (const auto& [r, s] : {Edge{r0, r1}, {r1, r2}, {r2, r3}, {r3, r0}})
      push(mesh, {p, q, r, s}, regions[t]);
  }
}

std::vector<Triangle> cut_triangles(const std::map<Edge, int>& middles, std::span<const Triangle> triangles) {
  std::vector<Triangle> finer;
  for (const auto& [a, b, c] : triangles) {
    const int ab = middles.at(std::minmax(a, b)), bc = middles.at(std::minmax(b, c)),
              ca = middles.at(std::minmax(c, a));
    finer.insert(finer.end(), {{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}});
  }
  return finer;
}

/// 3 x nodes of the cut mesh by 3 x free nodes.
Eigen::SparseMatrix<double> matrix_of(std::span<const Follows> follows, std::size_t free) {
  std::vector<Eigen::Triplet<double>> entries;
  for (int node = 0; node < std::ssize(follows); ++node)
    for (const auto& [of, weight] : follows[node])
      for (int axis = 0; axis < 3; ++axis) entries.emplace_back(3 * node + axis, 3 * of + axis, weight);
  Eigen::SparseMatrix<double> matrix(3 * std::ssize(follows), 3 * static_cast<Eigen::Index>(free));
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

std::vector<Triangle> between_touched(std::span<const Triangle> surface, std::span<const int> touched) {
  std::vector<Triangle> triangles;
  for (const Triangle& triangle : surface)
    if (std::ranges::all_of(triangle, [&](int node) { return std::ranges::binary_search(touched, node); }))
      triangles.push_back(triangle);
  return triangles;
}

}  // namespace

FinerBody finer_inside(const TetMesh& mesh, std::span<const Material> materials, std::span<const int> touched,
                       int cuts) {
  if (cuts == 0) return {.nodes = mesh.nodes, .K = stiffness(mesh, materials)};
  Cut cut{.mesh = mesh, .surface = extract_surface(mesh).triangles, .body = {.nodes = mesh.nodes}};
  cut.touched = between_touched(cut.surface, touched);
  for (int node = 0; node < std::ssize(mesh.nodes); ++node) cut.follows.push_back({{node, 1.0}});
  for (int i = 0; i < cuts; ++i) {
    const std::map<Edge, int> middles = add_middles(cut);
    cut_tetrahedra(middles, cut.mesh);
    cut.surface = cut_triangles(middles, cut.surface);
    cut.touched = cut_triangles(middles, cut.touched);
  }
  const Eigen::SparseMatrix<double> follow = matrix_of(cut.follows, cut.body.nodes.size());
  cut.body.K = follow.transpose() * stiffness(cut.mesh, materials) * follow;
  return std::move(cut.body);
}

std::vector<int> with_added(const FinerBody& body, std::vector<int> group) {
  std::vector<char> in(body.nodes.size(), 0);
  for (const int node : group) in[node] = 1;
  const std::size_t first = body.nodes.size() - body.between.size();
  for (std::size_t i = 0; i < body.between.size(); ++i)
    if (const auto [a, b] = body.between[i]; a >= 0 && in[a] != 0 && in[b] != 0) {
      in[first + i] = 1;
      group.push_back(static_cast<int>(first + i));
    }
  return group;
}

}  // namespace palpate::sim
