#include "sim/mesh/quality.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <numeric>

#include "sim/mesh/faces.hpp"
#include "sim/mesh/name_elements.hpp"
#include "sim/mesh/surface.hpp"
#include "sim/mesh/volume.hpp"

namespace palpate::sim {
namespace {

constexpr double kSliverAngle = 1.0;                        // [degree]
constexpr double kSmallestBody = 1e-3, kLargestBody = 2.0;  // [m]

struct Shape {
  double min_dihedral = 0.0, max_dihedral = 0.0;  // [degree]
  double radius_ratio = 0.0;
  double min_edge = 0.0, max_edge = 0.0;  // [m]
};

/// Angle between two faces, inside the tetrahedron, from their outward normals n and m: pi minus the
/// normals'.
double dihedral(const Vec3& n, const Vec3& m) {
  if (n.norm() == 0 || m.norm() == 0)
    return 0.0;  // a face without area has no angle; the flattest is reported
  return (std::numbers::pi - std::atan2(n.cross(m).norm(), n.dot(m))) * 180.0 / std::numbers::pi;
}

/// 3 r_in / r_circum with r_in = 3 V / A and r_circum = |a^2 (b x c) + b^2 (c x a) + c^2 (a x b)| / (12 V),
/// edges a, b, c from one corner, A the area of the four faces. Source: [Parthasarathy1994].
double radius_ratio(const std::array<Vec3, 4>& corner, double area) {
  const Vec3 a = corner[1] - corner[0], b = corner[2] - corner[0], c = corner[3] - corner[0];
  const double volume = std::abs(a.cross(b).dot(c)) / 6.0;
  const double circum =
      (a.squaredNorm() * b.cross(c) + b.squaredNorm() * c.cross(a) + c.squaredNorm() * a.cross(b)).norm();
  const double denominator = area * circum;
  return denominator > 0 ? 108.0 * volume * volume / denominator : 0.0;
}

Shape measure(const TetMesh& mesh, const Tetrahedron& tetrahedron) {
  std::array<Vec3, 4> corner, normal;
  for (std::size_t i = 0; i < 4; ++i) corner[i] = mesh.nodes[tetrahedron[i]];
  double area = 0.0;
  for (std::size_t f = 0; f < 4; ++f) {
    const auto at = [&](std::size_t i) -> const Vec3& { return corner[kOutwardFaces[f][i]]; };
    normal[f] = (at(1) - at(0)).cross(at(2) - at(0));
    area += normal[f].norm() / 2.0;
  }
  Shape shape{.min_dihedral = 180.0, .min_edge = std::numeric_limits<double>::infinity()};
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const double angle = dihedral(normal[i], normal[j]), edge = (corner[i] - corner[j]).norm();
      shape.min_dihedral = std::min(shape.min_dihedral, angle);
      shape.max_dihedral = std::max(shape.max_dihedral, angle);
      shape.min_edge = std::min(shape.min_edge, edge);
      shape.max_edge = std::max(shape.max_edge, edge);
    }
  shape.radius_ratio = radius_ratio(corner, area);
  return shape;
}

/// Parts of a mesh that share no node, in the order of their first nodes.
struct Pieces {
  std::vector<int> first_nodes;
  std::vector<int> nodes;  // how many each has
};

Pieces find_pieces(const TetMesh& mesh) {
  std::vector<int> parent(mesh.nodes.size());
  std::iota(parent.begin(), parent.end(), 0);
  const auto root = [&](int node) {
    while (parent[node] != node) {
      int& up = parent[node];
      up = parent[up];
      node = up;
    }
    return node;
  };
  std::vector<bool> used(mesh.nodes.size(), false);
  for (const Tetrahedron& tetrahedron : mesh.tetrahedra)
    for (const int node : tetrahedron) {
      used[node] = true;
      const int a = root(tetrahedron[0]), b = root(node);
      parent[std::max(a, b)] = std::min(a, b);
    }
  std::map<int, int> sizes;
  for (std::size_t i = 0; i < used.size(); ++i)
    if (used[i]) ++sizes[root(static_cast<int>(i))];
  Pieces pieces;
  for (const auto& [first, size] : sizes) {
    pieces.first_nodes.push_back(first);
    pieces.nodes.push_back(size);
  }
  return pieces;
}

void warn_of_pieces(const TetMesh& mesh, const Pieces& pieces, MeshQuality& quality) {
  if (pieces.nodes.size() < 2) return;
  std::string list;
  for (std::size_t i = 0; i < std::min<std::size_t>(pieces.nodes.size(), 5); ++i)
    list += fmt::format("{}{} nodes (one is node {})", i == 0 ? "" : ", ", pieces.nodes[i],
                        node_tag(mesh, pieces.first_nodes[i]));
  if (pieces.nodes.size() > 5) list += ", ...";
  quality.warnings.push_back(
      fmt::format("The mesh is in {} pieces that share no node: {}. Each needs a support of its own.",
                  pieces.nodes.size(), list));
}

void warn_of_size(MeshQuality& quality) {
  const double size = (quality.upper - quality.lower).maxCoeff();
  if (size >= kSmallestBody && size <= kLargestBody) return;
  quality.warnings.push_back(fmt::format(
      "The body is {:.4g} m long; bodies are mostly between 1 mm and 2 m. Was the unit right?", size));
}

}  // namespace

MeshQuality measure_quality(const TetMesh& mesh) {
  MeshQuality quality;
  quality.nodes = static_cast<int>(mesh.nodes.size());
  quality.tetrahedra = static_cast<int>(mesh.tetrahedra.size());
  if (mesh.tetrahedra.empty()) return quality;

  Eigen::AlignedBox3d box;
  quality.min_dihedral = 180.0;
  quality.min_radius_ratio = 1.0;
  quality.min_edge = std::numeric_limits<double>::infinity();
  int slivers = 0, worst = 0;
  for (int t = 0; const Tetrahedron& tetrahedron : mesh.tetrahedra) {
    const Shape shape = measure(mesh, tetrahedron);
    for (const int node : tetrahedron) box.extend(mesh.nodes[node]);
    quality.volume += signed_volume(mesh, tetrahedron);
    if (shape.min_dihedral < quality.min_dihedral) worst = t;
    slivers += shape.min_dihedral < kSliverAngle;
    quality.min_dihedral = std::min(quality.min_dihedral, shape.min_dihedral);
    quality.max_dihedral = std::max(quality.max_dihedral, shape.max_dihedral);
    quality.min_radius_ratio = std::min(quality.min_radius_ratio, shape.radius_ratio);
    quality.mean_radius_ratio += shape.radius_ratio / quality.tetrahedra;
    quality.min_edge = std::min(quality.min_edge, shape.min_edge);
    quality.max_edge = std::max(quality.max_edge, shape.max_edge);
    ++t;
  }
  quality.lower = box.min();
  quality.upper = box.max();
  const Surface surface = extract_surface(mesh);
  quality.surface_nodes = static_cast<int>(surface.nodes.size());
  quality.surface_triangles = static_cast<int>(surface.triangles.size());
  const Pieces pieces = find_pieces(mesh);
  quality.components = static_cast<int>(pieces.nodes.size());

  if (slivers > 0)
    quality.warnings.push_back(fmt::format(
        "{} of {} tetrahedra are slivers (an angle between two faces below {} degree); the worst has {:.3g} "
        "degree: {}. Forces near them are less exact.",
        slivers, quality.tetrahedra, kSliverAngle, quality.min_dihedral, name_tetrahedron(mesh, worst)));
  warn_of_size(quality);
  warn_of_pieces(mesh, pieces, quality);
  return quality;
}

}  // namespace palpate::sim
