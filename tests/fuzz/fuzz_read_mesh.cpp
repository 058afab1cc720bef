#include <cstdint>
#include <cstdlib>
#include <stdexcept>

#include "sim/mesh/parse_mesh.hpp"
#include "sim/mesh/quality.hpp"

// Any bytes give a mesh that later code can trust, or std::invalid_argument.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace palpate::sim;
  try {
    const TetMesh mesh = parse_mesh({reinterpret_cast<const char*>(data), size}, "fuzz", 1.0).mesh;
    if (mesh.region.size() != mesh.tetrahedra.size() || mesh.node_tags.size() != mesh.nodes.size())
      std::abort();
    for (const Tetrahedron& tetrahedron : mesh.tetrahedra)
      for (const int node : tetrahedron)
        if (node < 0 || static_cast<std::size_t>(node) >= mesh.nodes.size()) std::abort();
    measure_quality(mesh);
    validate(mesh);
  } catch (const std::invalid_argument&) {
  }
  return 0;
}
