#include "sim/contact/laws.hpp"

#include <gtest/gtest.h>

#include <Eigen/SVD>
#include <cmath>

#include "sim/contact/kuroda/kuroda.hpp"
#include "sim/cycle/press.hpp"
#include "tests/sim/support/two_boxes.hpp"

namespace palpate::sim {
namespace {

using test::compile_scene;
using test::TwoBoxes;
using test::write_two_boxes;

constexpr double kDepth = 1.5e-3;  // [m]

Simulation pressed(const Model& model, double depth = kDepth) {
  Simulation simulation(model);
  simulation.step(displaced_by(model, depth), kCyclePeriod);
  return simulation;
}

/// The law's own buffers after the last cycle.
const PrescribedScratch& prescribed(const Simulation& simulation) {
  return dynamic_cast<const PrescribedScratch&>(*simulation.law_scratch());
}
const std::vector<PairShare>& shares_of(const Simulation& simulation) {
  return dynamic_cast<const KurodaScratch&>(*simulation.law_scratch()).shares;
}

Override lower_modulus(const char* value) {
  return {"bodies.lower.young_modulus", value};
}
const Override kSibille{"contact.model", "sibille"}, kNone{"contact.model", "none"};

double force_at(const std::filesystem::path& scene, std::initializer_list<Override> overrides,
                double depth = kDepth) {
  const Model model = compile_scene(scene, std::vector<Override>(overrides));
  return normal_force(model.probes[0], press(model, depth, 1).curve.back().probe_forces[0]);
}

// Equations (3) and (4): |u_A| : |u_B| = |f_B| : |f_A|, and together they make up u_temp. Checked on the
// pairs whose node and polygon nobody else asked for more.
TEST(Kuroda, SharesTheOverlapInTheRatioOfTheResistances) {
  const Model model = compile_scene(write_two_boxes({.shift = 1.7e-3}));
  const Simulation simulation = pressed(model);
  const PrescribedScratch& buffers = prescribed(simulation);
  int checked = 0;
  for (std::size_t i = 0; i < buffers.pairs.size(); ++i) {
    const CollidingPair& pair = buffers.pairs[i];
    const PairShare& share = shares_of(simulation)[i];
    const double sum = share.polygon_force + share.node_force;
    const Vec3 u_temp = -pair.depth * pair.normal;
    const std::size_t node = pair.node;
    const Claims& claims = buffers.bodies[pair.node_body].claims;
    const double asked_of_node = share.polygon_force / sum * pair.depth;
    if (std::abs(std::sqrt(claims.squared[node]) - asked_of_node) > 1e-12 * pair.depth) continue;
    ++checked;
    EXPECT_LT((claims.displacement[node] + share.polygon_force / sum * u_temp).norm(), 1e-14 * pair.depth);
    // and the node is really there at the end of the cycle
    const Eigen::VectorXd moved =
        simulation.displacement(pair.node_body) - simulation.free_state().motion[pair.node_body].displacement;
    EXPECT_LT((moved.segment<3>(3 * pair.node) - claims.displacement[node]).norm(), 1e-9 * pair.depth);
  }
  EXPECT_GE(checked, 3);
}

/// Depth at which one node alone has passed one polygon.
double depth_of_single_contact(const Model& model) {
  for (double depth = 0.2e-3; depth < 3e-3; depth += 5e-6) {
    const Simulation simulation = pressed(model, depth);
    if (prescribed(simulation).pairs.size() == 1) return depth;
  }
  return 0.0;
}

TEST(Kuroda, OneContactIsClosedExactlyAndSharedByTheRatio) {
  const Model model = compile_scene(write_two_boxes({.divisions = 5, .upper_divisions = 6, .shift = 1.1e-3}));
  const double depth = depth_of_single_contact(model);
  ASSERT_GT(depth, 0.0);
  const Simulation simulation = pressed(model, depth);
  const PrescribedScratch& buffers = prescribed(simulation);
  const CollidingPair& pair = buffers.pairs.front();
  const PairShare& share = shares_of(simulation).front();
  const std::size_t a = pair.node_body, b = pair.polygon_body;
  const Vec3 u_a = (simulation.displacement(pair.node_body) - simulation.free_state().motion[a].displacement)
                       .segment<3>(3 * pair.node);
  for (const int corner : model.bodies[b].polygons.triangles[pair.polygon]) {
    const Vec3 u_b =
        (simulation.displacement(pair.polygon_body) - simulation.free_state().motion[b].displacement)
            .segment<3>(3 * corner);
    EXPECT_LT((u_b - u_a + pair.depth * pair.normal).norm(), 1e-9 * pair.depth);  // u_B - u_A = u_temp
    EXPECT_NEAR(u_a.norm() * share.node_force, u_b.norm() * share.polygon_force,
                1e-9 * u_a.norm() * share.node_force);
  }
  EXPECT_LT(press(model, depth, 1).curve.back().penetration.front(), 1e-9 * pair.depth);
}

// Only where the polygon is the one of the two with the larger force do it and the node move; which that is, the
// other reading tells as well.
TEST(Kuroda, ReadLiterallyMovesTheSideOfTheLargerForce) {
  const auto scene = write_two_boxes({.shift = 1.7e-3});
  const Model every = compile_scene(scene);
  const Model literal = compile_scene(scene, std::vector<Override>{{"contact.reading", "literal"}});
  const Simulation all = pressed(every), some = pressed(literal);
  const std::vector<PairShare>&shares = shares_of(some), &same = shares_of(all);
  std::vector<std::vector<char>> expected{std::vector<char>(every.bodies[0].rest.cols(), 0),
                                          std::vector<char>(every.bodies[1].rest.cols(), 0)};
  int left_out = 0;
  for (std::size_t i = 0; i < shares.size(); ++i) {
    EXPECT_EQ(shares[i].polygon_force, same[i].polygon_force);  // temporary deformation is that of all pairs
    const CollidingPair& pair = prescribed(some).pairs[i];
    if (shares[i].polygon_force < shares[i].node_force) {
      ++left_out;
      continue;
    }
    expected[pair.node_body][pair.node] = 1;
    for (const int corner : literal.bodies[pair.polygon_body].polygons.triangles[pair.polygon])
      expected[pair.polygon_body][corner] = 1;
  }
  EXPECT_GT(left_out, 0);
  EXPECT_LT(left_out, std::ssize(shares));
  for (std::size_t body = 0; body < 2; ++body)
    for (std::size_t node = 0; node < expected[body].size(); ++node)
      EXPECT_EQ(prescribed(some).bodies[body].claims.squared[node] >= 0.0, expected[body][node] == 1);
}

TEST(Kuroda, ABodyAMillionTimesStifferDoesNotYield) {
  const auto scene = write_two_boxes({.shift = 1.7e-3});
  const Model model = compile_scene(scene, std::vector{lower_modulus("1e6 MPa")});
  const Simulation simulation = pressed(model);
  ASSERT_FALSE(prescribed(simulation).pairs.empty());
  double deepest = 0.0;
  for (const CollidingPair& pair : prescribed(simulation).pairs) deepest = std::max(deepest, pair.depth);
  EXPECT_LT(simulation.displacement(1).lpNorm<Eigen::Infinity>(), 1e-5 * deepest);
  EXPECT_GT(simulation.displacement(0).lpNorm<Eigen::Infinity>(), deepest);
}

TEST(Kuroda, AStifferNeighbourPushesBackHarder) {
  const auto scene = write_two_boxes({.shift = 1.7e-3});
  const double none = force_at(scene, {kNone}), soft = force_at(scene, {lower_modulus("1 MPa")}),
               hard = force_at(scene, {lower_modulus("5 MPa")});
  EXPECT_LT(none, soft);
  EXPECT_LT(soft, hard);
}

// Linear elasticity: all moduli times c, all forces times c.
TEST(Kuroda, ForceScalesWithTheModuliTogether) {
  const auto scene = write_two_boxes({.shift = 1.7e-3});
  const double once = force_at(scene, {lower_modulus("3 MPa"), {"bodies.upper.young_modulus", "1 MPa"}});
  const double tenfold = force_at(scene, {lower_modulus("30 MPa"), {"bodies.upper.young_modulus", "10 MPa"}});
  EXPECT_NEAR(tenfold / once, 10.0, 1e-9);
}

TEST(Sibille, BringsEveryCollidingNodeToOnePlane) {
  const Model model = compile_scene(write_two_boxes({.shift = 1.7e-3}), std::vector{kSibille});
  const Simulation simulation = pressed(model);
  const PrescribedScratch& buffers = prescribed(simulation);
  ASSERT_GE(buffers.pairs.size(), 4u);
  Eigen::Matrix3Xd places(3, static_cast<Eigen::Index>(buffers.pairs.size()));
  for (std::size_t i = 0; i < buffers.pairs.size(); ++i) {
    const CollidingPair& pair = buffers.pairs[i];
    places.col(static_cast<Eigen::Index>(i)) =
        model.bodies[pair.node_body].rest.col(pair.node) +
        simulation.displacement(pair.node_body).segment<3>(3 * pair.node);
  }
  const Eigen::Matrix3Xd centred = places.colwise() - places.rowwise().mean();
  const Eigen::Vector3d extents = centred.jacobiSvd().singularValues();
  EXPECT_LT(extents[2], 1e-9 * extents[0]);
}

TEST(Sibille, KnowsNothingOfTheNeighboursStiffness) {
  const auto scene = write_two_boxes({.shift = 1.7e-3});
  const double soft = force_at(scene, {kSibille, lower_modulus("1 MPa")});
  const double hard = force_at(scene, {kSibille, lower_modulus("5 MPa")});
  EXPECT_NEAR(hard / soft, 1.0, 1e-9);
  EXPECT_GT(std::abs(soft - force_at(scene, {kNone})), 1e-3 * soft);
}

TEST(Sibille, MovesTheNeighbourWithAForceProportionalToItsModulus) {
  const auto scene = write_two_boxes({.shift = 1.7e-3});
  const auto force_on_lower = [&](const char* modulus) {
    const Model model = compile_scene(scene, std::vector{kSibille, lower_modulus(modulus)});
    return press(model, kDepth, 1).curve.back().pairs.front().force_on[1];
  };
  const Vec3 soft = force_on_lower("1 MPa"), hard = force_on_lower("5 MPa");
  EXPECT_GT(soft.norm(), 0.0);
  EXPECT_LT((hard - 5.0 * soft).norm(), 1e-9 * hard.norm());
}

}  // namespace
}  // namespace palpate::sim
