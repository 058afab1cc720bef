#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/end_to_end/program.hpp"
#include "tests/sim/support/two_boxes.hpp"

namespace palpate::app {
namespace {

TEST(Volume, OfABoxIsItsEdgesProduct) {
  const std::string box = sim::test::write_two_boxes().parent_path() / "lower.msh";  // 30 x 30 x 20 mm
  const auto printed = test::run({"volume", box, "--unit", "m", "--format", "json"});
  ASSERT_EQ(printed.exit_code, 0) << printed.err;
  EXPECT_NEAR(nlohmann::json::parse(printed.out)["volume"], 18e-6, 1e-18);
}

TEST(Volume, IsInTheHelp) {
  EXPECT_THAT(test::run({"--help"}).out, testing::HasSubstr("How much a mesh holds"));
}

}  // namespace
}  // namespace palpate::app
