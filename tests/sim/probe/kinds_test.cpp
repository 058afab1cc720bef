#include "sim/probe/kinds.hpp"

#include <gmock/gmock.h>

#include <numeric>
#include <set>
#include <stdexcept>
#include <string>

#include "sim/mesh/surface.hpp"
#include "sim/scene/accepted.hpp"
#include "tests/sim/support/box_mesh.hpp"

namespace palpate::sim {
namespace {

TEST(ProbeKinds, HaveNamesOfTheirOwnThatASceneAccepts) {
  std::set<std::string_view> names;
  for (const ProbeKind* kind : probe_kinds()) {
    EXPECT_TRUE(names.insert(kind->keys.name).second) << kind->keys.name;
    EXPECT_EQ(&probe_kind(kind->keys.name), kind);
  }
  const base::Words words = probe_kind_words();
  ASSERT_EQ(words.now.size(), names.size());
  for (const base::Word& known : words.now) {
    EXPECT_TRUE(names.contains(known.word)) << known.word;
    EXPECT_FALSE(known.meaning.empty()) << known.word;  // for the reference
  }
  for (const std::string_view later : words.later) EXPECT_FALSE(names.contains(later));
  EXPECT_EQ(probe_kind_keys().size(), names.size());
  EXPECT_THROW(probe_kind("other"), std::invalid_argument);
}

TEST(ProbeKinds, HoldTheMiddleWithWeightsOfSumOne) {
  const TetMesh mesh = test::box_mesh(6, 6, 2, Vec3(0.03, 0.03, 0.01));
  const Surface surface = extract_surface(mesh);
  const int middle = surface.nodes[surface.nodes.size() / 2];
  for (const ProbeKind* kind : probe_kinds()) {
    if (kind->keys.takes_group) continue;  // it holds a group, see region_test.cpp
    Probe probe;
    const ProbeSpec spec{.name = "finger", .kind = std::string(kind->keys.name), .radius = 8e-3};
    kind->hold(spec, mesh, surface, middle, probe);
    if (probe.tip) {
      EXPECT_THAT(probe.tip->nodes, testing::Contains(middle)) << kind->keys.name;
      continue;
    }
    EXPECT_THAT(probe.nodes, testing::Contains(middle)) << kind->keys.name;
    ASSERT_EQ(probe.weights.size(), probe.nodes.size());
    EXPECT_NEAR(std::accumulate(probe.weights.begin(), probe.weights.end(), 0.0), 1.0, 1e-12);
    EXPECT_EQ(probe.nodes.size() > 1, kind->keys.takes_radius);
  }
}

TEST(ProbeKinds, PressOnlyInTheSkin) {
  for (const ProbeKind* kind : probe_kinds()) {
    if (kind->keys.takes_group || kind->keys.name == "fingertip")
      continue;  // one holds on, the other holds nothing
    const Probe probe{.direction = Vec3(0, 0, -1), .axes = Eigen::Matrix3d::Identity()};
    ProbeRow row;
    kind->prescribe(probe, {Vec3(1e-3, 0, -2e-3)}, row);
    EXPECT_TRUE(row.pressing) << kind->keys.name;
    EXPECT_EQ(row.value, Vec3(1e-3, 0, -2e-3));
    kind->prescribe(probe, {Vec3(1e-3, 0, 2e-3)}, row);
    EXPECT_FALSE(row.pressing) << kind->keys.name;
  }
}

}  // namespace
}  // namespace palpate::sim
