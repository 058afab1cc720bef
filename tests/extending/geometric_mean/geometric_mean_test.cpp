#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/end_to_end/program.hpp"
#include "tests/support/temporary_folder.hpp"

namespace palpate::analysis {
namespace {

TEST(GeometricMean, IsRunByItsName) {
  const palpate::test::TemporaryFolder folder;
  const std::string file = folder / "estimates.csv";
  std::ofstream(file) << "estimate\n1\n10\n100\n";
  const auto ran = palpate::test::run({"stats", "geometric-mean", file, "--format", "json"});
  ASSERT_EQ(ran.exit_code, 0) << ran.err;
  const auto result = nlohmann::json::parse(ran.out);
  EXPECT_NEAR(result["geometric_mean"], 10.0, 1e-12);
  // The quantile of Student's t with 2 degrees of freedom, (2p - 1)/sqrt(2p(1 - p)), times the standard error.
  const double quantile = 0.95 / std::sqrt(2.0 * 0.975 * 0.025);
  const double factor = std::exp(quantile * std::log(10.0) / std::sqrt(3.0));
  EXPECT_NEAR(result["interval"]["upper"].get<double>() / (10.0 * factor), 1.0, 1e-12);
  EXPECT_NEAR(result["interval"]["lower"].get<double>() / (10.0 / factor), 1.0, 1e-12);
}

TEST(GeometricMean, IsAmongThoseThatHelpLists) {
  EXPECT_THAT(palpate::test::run({"stats", "--help"}).out, testing::HasSubstr("geometric-mean"));
}

}  // namespace
}  // namespace palpate::analysis
