#include "sim/compile/selection.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

namespace palpate::sim {
namespace {

using testing::AllOf;
using testing::HasSubstr;

std::string refusal_of_group(const TetMesh& mesh) {
  try {
    select(mesh, NodeSelection(std::string("31")), "bodies.box.fixed");
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "nothing thrown";
}

TEST(Selection, NamesTheGroupsThereAreOrHowOneIsNamed) {
  TetMesh mesh;
  mesh.nodes = {Vec3::Zero()};
  EXPECT_THAT(refusal_of_group(mesh),
              AllOf(HasSubstr("bodies.box.fixed: the mesh has no group \"31\"; it has no named groups: "),
                    HasSubstr("Physical Surface(\"NAME\")"), HasSubstr("integer point array group.NAME")));
  mesh.node_groups["bottom"] = {0};
  EXPECT_EQ(refusal_of_group(mesh), "bodies.box.fixed: the mesh has no group \"31\"; it has: bottom");
}

TEST(Selection, NamesTheRegionsThereAreOrHowOneIsNamed) {
  BodySpec spec{.name = "box"};
  spec.regions["nodule"] = {};
  try {
    materials_of(spec, TetMesh{});
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_THAT(error.what(), HasSubstr("it has none: in Gmsh, Physical Volume(\"NAME\")"));
  }
}

}  // namespace
}  // namespace palpate::sim
