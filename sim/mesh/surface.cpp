#include "sim/mesh/surface.hpp"

#include <algorithm>

#include "sim/mesh/faces.hpp"

namespace palpate::sim {

std::vector<Face> sorted_faces(const TetMesh& mesh) {
  std::vector<Face> faces;
  faces.reserve(4 * mesh.tetrahedra.size());
  for (int t = 0; const Tetrahedron& tetrahedron : mesh.tetrahedra) {
    for (const Triangle& local : kOutwardFaces) {
      Face face{.tetrahedron = t};
      for (std::size_t i = 0; i < 3; ++i) face.corners[i] = tetrahedron[local[i]];
      face.key = face.corners;
      std::ranges::sort(face.key);
      faces.push_back(face);
    }
    ++t;
  }
  std::ranges::sort(faces, [](const Face& a, const Face& b) {
    return a.key != b.key ? a.key < b.key : a.tetrahedron < b.tetrahedron;
  });
  return faces;
}

bool same_sense(const Face& a, const Face& b) {
  const auto start = std::ranges::find(b.corners, a.corners[0]) - b.corners.begin();
  return b.corners[(start + 1) % 3] == a.corners[1];
}

Surface extract_surface(const TetMesh& mesh) {
  const std::vector<Face> faces = sorted_faces(mesh);
  std::vector<Face> single;
  for (std::size_t first = 0, last = 0; first < faces.size(); first = last) {
    while (last < faces.size() && faces[last].key == faces[first].key) ++last;
    if (last - first == 1) single.push_back(faces[first]);
  }
  // Neighbours in the file stay neighbours on the surface, which keeps later passes over it in the cache.
  std::ranges::stable_sort(single,
                           [](const Face& a, const Face& b) { return a.tetrahedron < b.tetrahedron; });

  Surface surface;
  surface.triangles.reserve(single.size());
  surface.behind.reserve(single.size());
  for (const Face& face : single) {
    surface.triangles.push_back(face.corners);
    surface.behind.push_back(face.tetrahedron);
    surface.nodes.insert(surface.nodes.end(), face.corners.begin(), face.corners.end());
  }
  std::ranges::sort(surface.nodes);
  surface.nodes.erase(std::unique(surface.nodes.begin(), surface.nodes.end()), surface.nodes.end());
  return surface;
}

}  // namespace palpate::sim
