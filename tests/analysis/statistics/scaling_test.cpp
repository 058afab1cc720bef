#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/analysis/support/ask.hpp"

using namespace palpate::analysis;
using testing::HasSubstr;

TEST(BradleyTerryStatistic, TakesSingleComparisonsAsCounts) {
  const auto single = run_statistic(
      "bradley-terry", {{"data", {{"winner", {"a", "a", "b", "a"}}, {"loser", {"b", "b", "a", "b"}}}}});
  const auto counts = run_statistic(
      "bradley-terry",
      {{"data", {{"winner", {"a", "b", "a"}}, {"loser", {"b", "a", "c"}}, {"count", {3, 1, 0}}}}});
  EXPECT_EQ(single.json, counts.json);
  EXPECT_EQ(single.json["items"][0]["wins"], 3);
}

TEST(BradleyTerryStatistic, PutsTheHighestValueFirst) {
  const std::string text =
      run_statistic("bradley-terry",
                    {{"data", {{"winner", {"a", "z"}}, {"loser", {"z", "a"}}, {"count", {1, 3}}}}})
          .text;
  EXPECT_LT(text.find("\nz: 0.549"), text.find("\na: -0.549"));  // R: log(3)/2
  EXPECT_THAT(text, HasSubstr("nothing is left to test"));
  EXPECT_THAT(refusal_of("bradley-terry", {{"data", {{"winner", {"a"}}, {"loser", {"b"}}, {"count", {-1}}}}}),
              HasSubstr("data:1: count is '-1'; accepted: a whole number from 0"));
}

TEST(StevensStatistic, SaysWhereLevelsMixWithPeople) {
  const std::string text = run_statistic("stevens", {{"data",
                                                      {{"examinee", {"a", "a", "a", "b", "b"}},
                                                       {"level", {1, 2, 4, 1, 2}},
                                                       {"estimate", {10, 19, 42, 1, 2.2}}}}})
                               .text;
  EXPECT_THAT(text, HasSubstr("the geometric means mix levels with people"));
  EXPECT_THAT(text, HasSubstr("Level 4: geometric mean 42 (1 examinee)"));
}
