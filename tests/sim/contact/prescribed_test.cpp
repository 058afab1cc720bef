#include <gtest/gtest.h>

#include <Eigen/Dense>

#include "sim/contact/prescribed/prescribed_law.hpp"
#include "tests/sim/support/two_boxes.hpp"

namespace palpate::sim {
namespace {

/// C_DD^-1 u_D by a dense solve that knows nothing of kept rows.
Eigen::VectorXd dense_solution(const Model& model, const std::vector<int>& nodes,
                               const Eigen::VectorXd& asked, bool pressing) {
  const Body& body = model.bodies[0];
  const Probe& probe = model.probes[0];
  const Eigen::Index probe_rows = pressing ? probe.axes.cols() : 0;
  Eigen::MatrixXd g = Eigen::MatrixXd::Zero(body.compliance->touch_touch.rows(), asked.size());
  for (Eigen::Index axis = 0; axis < probe_rows; ++axis)
    for (std::size_t i = 0; i < probe.nodes.size(); ++i)
      g.col(axis).segment<3>(3 * probe.nodes[i]) += probe.weights[i] * probe.axes.col(axis);
  for (std::size_t i = 0; i < nodes.size(); ++i)
    for (int c = 0; c < 3; ++c) g(3 * nodes[i] + c, probe_rows + 3 * static_cast<Eigen::Index>(i) + c) = 1.0;
  return (g.transpose() * body.compliance->touch_touch * g).llt().solve(asked);
}

class PrescribedAgainstDense : public ::testing::TestWithParam<const char*> {};

// Sets of nodes come and go as in a press; kept rows must never show.
TEST_P(PrescribedAgainstDense, GivesTheSameForcesWhateverSetCameBefore) {
  const Model model = test::compile_scene(test::write_two_boxes({.probe = GetParam()}));
  const std::vector<int>& may_touch = model.bodies[0].colliding_nodes;
  PrescribedSolve solve = contact_solve(model, 0);
  std::vector<Vec3> values(model.bodies[0].rest.cols());
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = 1e-3 * Vec3::Random();
  ProbeRows rows(1);
  for (const auto& [pressing, picked] :
       std::vector<std::pair<bool, std::vector<std::size_t>>>{{true, {2, 5, 9}},
                                                              {true, {2, 5, 9, 11}},
                                                              {true, {2, 7, 9}},
                                                              {false, {2, 7, 9}},
                                                              {true, {2, 7, 9}},
                                                              {true, {0}}}) {
    rows[0].pressing = pressing;
    rows[0].value = Vec3(1e-3, 2e-3, -3e-3);
    std::vector<int> nodes;
    for (const std::size_t i : picked) nodes.push_back(may_touch[i]);
    ASSERT_TRUE(solve.factor(rows, nodes));
    const auto multipliers = solve.solve(&rows, values);
    Eigen::VectorXd asked(solve.rows());
    for (Eigen::Index i = 0; i < solve.probe_rows(); ++i) asked[i] = rows[0].value[i];
    for (std::size_t i = 0; i < nodes.size(); ++i)
      asked.segment<3>(solve.probe_rows() + 3 * static_cast<Eigen::Index>(i)) = values[nodes[i]];
    const Eigen::VectorXd expected = dense_solution(model, nodes, asked, pressing);
    const Eigen::Map<const Eigen::VectorXd> found(multipliers.data(), solve.rows());
    EXPECT_LT((found - expected).norm(), 1e-10 * expected.norm());
  }
}

INSTANTIATE_TEST_SUITE_P(Probes, PrescribedAgainstDense,
                         ::testing::Values("kind = \"point\"", "kind = \"point\"\ntangential = \"free\"",
                                           "kind = \"pad\"\nradius = \"6 mm\""));

TEST(Claims, KeepTheLargerDisplacementAndTheFirstOfTwoAlike) {
  Claims claims(4);
  claims.ask(2, Vec3(1, 0, 0), 0);
  claims.ask(2, Vec3(0, 1, 0), 1);
  EXPECT_EQ(claims.displacement[2], Vec3(1, 0, 0));
  claims.ask(2, Vec3(0, 0, 2), 1);
  EXPECT_EQ(claims.displacement[2], Vec3(0, 0, 2));
  EXPECT_EQ(claims.touch_pair[2], 1);
  claims.ask(0, Vec3(1, 1, 1), 0);
  claims.sort();
  EXPECT_EQ(claims.nodes, (std::vector<int>{0, 2}));
}

TEST(Claims, LeaveWhatAProbeHolds) {
  Claims claims(4);
  claims.hold(std::vector<int>{1, 2}, std::vector<double>{1.0, 0.0});
  claims.ask(2, Vec3(1, 0, 0), 0);  // of its nodes, but without a weight where it is now
  EXPECT_EQ(claims.nodes, (std::vector<int>{2}));
  claims.ask(1, Vec3(1, 0, 0), 0);
  EXPECT_EQ(claims.nodes, (std::vector<int>{2}));
}

}  // namespace
}  // namespace palpate::sim
