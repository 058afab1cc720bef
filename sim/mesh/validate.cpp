#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <stdexcept>

#include "sim/mesh/faces.hpp"
#include "sim/mesh/name_elements.hpp"
#include "sim/mesh/quality.hpp"
#include "sim/mesh/surface.hpp"
#include "sim/mesh/volume.hpp"

namespace palpate::sim {
namespace {

constexpr std::size_t kNamed = 5;      // elements named in one message
constexpr double kFlatVolume = 1e-10;  // of the longest edge cubed

/// Collects the names of what is wrong and throws one sentence about all of it.
struct Complaint {
  std::size_t count = 0;
  std::string names;

  void add(const std::string& name) {
    if (count++ < kNamed) names += (names.empty() ? "" : ", ") + name;
  }
  void refuse(const char* found, const char* accepted) const {
    if (count == 0) return;
    const std::string more = count > kNamed ? fmt::format(" and {} more", count - kNamed) : "";
    throw std::invalid_argument(fmt::format("{}: {}{}; {}", found, names, more, accepted));
  }
};

/// No volume beyond what the shape or the rounding of the coordinates accounts for.
bool is_flat(const TetMesh& mesh, const Tetrahedron& tetrahedron) {
  double longest = 0.0, farthest = 0.0;
  for (std::size_t i = 0; i < 4; ++i) {
    const Vec3& x = mesh.nodes[tetrahedron[i]];
    farthest = std::max(farthest, x.cwiseAbs().maxCoeff());
    for (std::size_t j = 0; j < i; ++j) longest = std::max(longest, (x - mesh.nodes[tetrahedron[j]]).norm());
  }
  const double rounding = 2 * std::numeric_limits<double>::epsilon() * farthest;
  return signed_volume(mesh, tetrahedron) <= longest * longest * std::max(kFlatVolume * longest, rounding);
}

void refuse_flat(const TetMesh& mesh) {
  Complaint flat;
  for (int t = 0; const Tetrahedron& tetrahedron : mesh.tetrahedra) {
    if (is_flat(mesh, tetrahedron)) flat.add(name_tetrahedron(mesh, t));
    ++t;
  }
  flat.refuse("tetrahedra without volume",
              "tetrahedra with a volume are accepted: mesh again or optimise the mesh");
}

void refuse_bad_faces(const TetMesh& mesh) {
  Complaint crowded, overlapping;
  const std::vector<Face> faces = sorted_faces(mesh);
  for (std::size_t first = 0, last = 0; first < faces.size(); first = last) {
    while (last < faces.size() && faces[last].key == faces[first].key) ++last;
    if (last - first > 2) {
      const Triangle& key = faces[first].key;
      crowded.add(fmt::format("face {}-{}-{} ({} tetrahedra)", node_tag(mesh, key[0]), node_tag(mesh, key[1]),
                              node_tag(mesh, key[2]), last - first));
    } else if (last - first == 2 && same_sense(faces[first], faces[first + 1])) {
      overlapping.add(fmt::format("{} with {}", name_tetrahedron(mesh, faces[first].tetrahedron),
                                  name_tetrahedron(mesh, faces[first + 1].tetrahedron)));
    }
  }
  crowded.refuse("the surface is open or not a manifold, for more than two tetrahedra share a face",
                 "one or two tetrahedra at a face are accepted");
  overlapping.refuse("tetrahedra overlap, lying on the same side of a common face",
                     "tetrahedra turned inside out cannot be mended by the order of their nodes: mesh again");
}

using Edge = std::pair<int, int>;

/// For every side a -> b of a surface triangle, seen from outside, the corner that follows b.
using NextCorner = std::map<Edge, int>;

NextCorner refuse_bad_edges(const TetMesh& mesh, const Surface& surface) {
  std::map<Edge, int> triangles_at;
  NextCorner next;
  for (const Triangle& triangle : surface.triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      const int a = triangle[i], b = triangle[(i + 1) % 3];
      next[{a, b}] = triangle[(i + 2) % 3];
      ++triangles_at[std::minmax(a, b)];
    }
  Complaint complaint;
  for (const auto& [edge, count] : triangles_at)
    if (count != 2)
      complaint.add(fmt::format("{} ({} triangles)", name_edge(mesh, edge.first, edge.second), count));
  complaint.refuse("the surface is open or not a manifold",
                   "an edge of the surface between exactly two triangles is accepted");
  return next;
}

/// Around each node the surface's triangles must close into one fan: two fans meet in a point alone.
void refuse_pinched(const TetMesh& mesh, const Surface& surface, const NextCorner& next) {
  std::map<int, std::size_t> triangles_at;
  std::map<int, int> neighbour;
  for (const Triangle& triangle : surface.triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      ++triangles_at[triangle[i]];
      neighbour[triangle[i]] = triangle[(i + 1) % 3];
    }
  Complaint pinched;
  for (const auto& [node, count] : triangles_at) {
    std::size_t fan = 0;
    const int start = neighbour.at(node);
    int at = start;
    do {
      at = next.at({node, at});
      ++fan;
    } while (at != start && fan < count);
    if (fan != count) pinched.add(fmt::format("node {}", node_tag(mesh, node)));
  }
  pinched.refuse("the surface is not a manifold: parts of it meet in one node alone",
                 "a node with one closed fan of triangles around it is accepted");
}

}  // namespace

void validate(const TetMesh& mesh) {
  if (mesh.tetrahedra.empty())
    throw std::invalid_argument("the mesh has no tetrahedron; a body filled with tetrahedra is accepted");
  refuse_flat(mesh);
  refuse_bad_faces(mesh);
  const Surface surface = extract_surface(mesh);
  refuse_pinched(mesh, surface, refuse_bad_edges(mesh, surface));
}

}  // namespace palpate::sim
