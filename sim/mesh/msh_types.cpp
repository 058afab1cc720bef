#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "sim/mesh/msh_content.hpp"

namespace palpate::sim {
namespace {

constexpr std::array<std::int64_t, 4> kFirstOrder = {15, 1, 2, 4};  // point, line, triangle, tetrahedron

struct RefusedType {
  std::int64_t type;
  const char* name;
  bool higher_order;
};

// The commonest of Gmsh's other types (its manual, chapter "Gmsh file formats").
constexpr std::array<RefusedType, 13> kRefused = {{{3, "4-node quadrangle", false},
                                                   {5, "8-node hexahedron", false},
                                                   {6, "6-node prism", false},
                                                   {7, "5-node pyramid", false},
                                                   {8, "3-node line", true},
                                                   {9, "6-node triangle", true},
                                                   {10, "9-node quadrangle", false},
                                                   {11, "10-node tetrahedron", true},
                                                   {12, "27-node hexahedron", false},
                                                   {21, "10-node triangle", true},
                                                   {26, "4-node line", true},
                                                   {29, "20-node tetrahedron", true},
                                                   {30, "35-node tetrahedron", true}}};

}  // namespace

int msh_dimension(const Cursor& in, std::int64_t type) {
  const auto accepted = std::ranges::find(kFirstOrder, type);
  if (accepted != kFirstOrder.end()) return static_cast<int>(accepted - kFirstOrder.begin());

  const auto known =
      std::ranges::find_if(kRefused, [&](const RefusedType& refused) { return refused.type == type; });
  const bool named = known != kRefused.end();
  const char* remedy = named && known->higher_order
                           ? "mesh again at first order (gmsh FILE.geo -3 -order 1 -o OUT.msh)"
                           : "fill the body with tetrahedra (in Gmsh: no Recombine, no hexahedral layers)";
  in.refuse_last(
      fmt::format("found element type {}{}; points, lines, triangles and 4-node tetrahedra (types 15, "
                  "1, 2, 4) are accepted: {}",
                  type, named ? fmt::format(" ({})", known->name) : "", remedy));
}

}  // namespace palpate::sim
