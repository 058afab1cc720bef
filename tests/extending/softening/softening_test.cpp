#include "tests/extending/softening/softening.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vector>

#include "sim/cycle/simulation.hpp"
#include "tests/end_to_end/program.hpp"
#include "tests/sim/support/two_boxes.hpp"

namespace palpate::sim {
namespace {

using testing::AllOf;
using testing::HasSubstr;

/// Force of a press on the upper box alone [N].
double force_with(std::vector<Override> overrides) {
  overrides.push_back({"contact.model", "none"});
  const Model model = test::compile_scene(test::write_two_boxes(), overrides);
  const ProbeDisplacement pressed{1e-3 * model.probes[0].direction};
  return Simulation(model).step({&pressed, 1}, 1e-3).probe_forces[0].norm();
}

TEST(Softening, TakesItsShareOfTheForce) {
  EXPECT_NEAR(force_with({{"bodies.upper.softening", "0.25"}}) / force_with({}), 0.75, 1e-12);
}

TEST(Softening, IsRefusedByItsKey) {
  const std::string scene = test::write_two_boxes();
  const auto refused = palpate::test::run({"press", scene, "--set", "bodies.upper.softening=1.5"});
  EXPECT_EQ(refused.exit_code, 1);
  EXPECT_THAT(
      refused.err,
      HasSubstr("bodies.upper.softening: found 1.5, accepted: a number greater than 0 and less than 1"));
}

TEST(Softening, IsListedByCheck) {
  const auto checked = palpate::test::run({"check", test::write_two_boxes()});
  EXPECT_THAT(checked.out, AllOf(HasSubstr("softening"), HasSubstr("no softening of a body")));
}

}  // namespace
}  // namespace palpate::sim
