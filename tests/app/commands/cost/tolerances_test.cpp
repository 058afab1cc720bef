#include "app/commands/cost/tolerances.hpp"

#include <gmock/gmock.h>

namespace palpate::app {
namespace {

const std::vector<sim::ToleranceCost> kCosts{
    {.tolerance = 0.0, .total = {1.5, 2, 3, 4}, .median_bound = 1e-12, .largest_bound = 2e-12, .cycles = 10},
    {.tolerance = 0.05,
     .total = {2.5, 5, 6, 7},
     .median_bound = 0.01,
     .largest_bound = 0.04,
     .cycles = 10,
     .ended_early = 4}};

TEST(CostTolerances, AreListedInJson) {
  const auto json = tolerances_json(kCosts);
  ASSERT_EQ(json.size(), 2U);
  EXPECT_EQ(json[1]["tolerance"], 0.05);
  EXPECT_EQ(json[1]["median"], 2.5);
  EXPECT_EQ(json[1]["p99_9"], 6);
  EXPECT_EQ(json[1]["bound"]["median"], 0.01);
  EXPECT_EQ(json[1]["bound"]["largest"], 0.04);
  EXPECT_EQ(json[1]["ended_early"], 4);
  EXPECT_TRUE(tolerances_json({}).is_array());
}

TEST(CostTolerances, AreDrawnOverTheBoundInPercent) {
  const Plot plot = over_bound({{"a scene", "a law", kCosts}}, "a machine");
  EXPECT_TRUE(plot.log_x && plot.log_y);
  const PlotSeries& series = plot.panels.at(0).series.at(0);
  EXPECT_EQ(series.name, "a law: a scene");
  EXPECT_THAT(series.x, testing::ElementsAre(testing::DoubleEq(2e-10), testing::DoubleEq(4)));
  EXPECT_THAT(series.y, testing::ElementsAre(1.5, 2.5));
  EXPECT_THAT(series.high, testing::ElementsAre(3, 6));
  EXPECT_THAT(plot.note, testing::HasSubstr("contact.tolerance 0 %, 5 %;"));
}

TEST(CostTolerances, HaveAPictureBesideTheOther) {
  EXPECT_EQ(tolerance_plot_file("out/cost.svg"), "out/cost-tolerance.svg");
  EXPECT_EQ(tolerance_plot_file("cost.png"), "cost-tolerance.png");
}

}  // namespace
}  // namespace palpate::app
