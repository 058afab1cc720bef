#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/analysis/support/ask.hpp"

using namespace palpate::analysis;
using testing::HasSubstr;

namespace {

const nlohmann::ordered_json kCounts = {{"examinee", {"a", "a", "b", "b"}},
                                        {"level", {1, 2, 1, 2}},
                                        {"correct", {1, 3, 2, 3}},
                                        {"trials", {4, 4, 4, 4}}};

}  // namespace

TEST(GlmmStatistic, TakesSingleAnswersAsCounts) {
  nlohmann::ordered_json single = {{"examinee", {}}, {"level", {}}, {"response", {}}};
  for (std::size_t row = 0; row < 4; ++row) {
    for (int k = 0; k < 4; ++k) {
      single["examinee"].push_back(kCounts["examinee"][row]);
      single["level"].push_back(kCounts["level"][row]);
      single["response"].push_back(k < kCounts["correct"][row].get<int>() ? 1 : 0);
    }
  }
  const auto counts = run_statistic("glmm", {{"data", kCounts}}).json;
  const auto answers = run_statistic("glmm", {{"data", single}}).json;
  EXPECT_EQ(counts["slope"], answers["slope"]);
  EXPECT_EQ(counts["jnd"], answers["jnd"]);
  EXPECT_EQ(answers["rows"], 16);
}

TEST(GlmmStatistic, SaysWhatTheAnswersMayBe) {
  nlohmann::ordered_json data = kCounts;
  data["response"] = {0, 1, 1, 0};
  EXPECT_THAT(refusal_of("glmm", {{"data", data}}), HasSubstr("both single answers and counts"));
  data.erase("correct"), data.erase("trials");
  data["response"] = {0, 1, 2, 0};
  EXPECT_THAT(refusal_of("glmm", {{"data", data}}),
              HasSubstr("data:3: response is '2'; accepted: 0 or 1 (also written as false or true)"));
  data.erase("response");
  EXPECT_THAT(refusal_of("glmm", {{"data", data}}), HasSubstr("neither single answers nor counts"));
  EXPECT_THAT(refusal_of("glmm", {{"data", kCounts}, {"nodes", 51}}), HasSubstr("nodes is 51; accepted: 1"));
}

TEST(GlmmStatistic, WritesWhatIsOpenInWords) {
  const std::string text = run_statistic("glmm", {{"data", kCounts}, {"nodes", 1}}).text;
  EXPECT_THAT(text, HasSubstr("16 answers of 2 examinees"));
  EXPECT_THAT(text, HasSubstr("any value by Fieller's theorem"));
  EXPECT_THAT(text, HasSubstr("Laplace approximation"));
  EXPECT_THAT(text, HasSubstr("converged"));
}

TEST(GlmmStatistic, SaysFirstThatAFitDidNotConverge) {
  const Outcome outcome = run_statistic("glmm", {{"data",
                                                  {{"examinee", {"a", "a", "a", "b", "b", "b"}},
                                                   {"level", {-1, 0, 1, -1, 0, 1}},
                                                   {"response", {0, 0, 1, 1, 1, 0}}}},
                                                 {"random", "slope"},
                                                 {"nodes", 5}});
  EXPECT_THAT(outcome.text, HasSubstr("6 answers of 2 examinees\nNOT CONVERGED"));
  EXPECT_EQ(outcome.json["convergence"]["converged"], false);
  EXPECT_TRUE(outcome.json["slope"]["standard_error"].is_null());
  EXPECT_TRUE(outcome.json["pse"]["interval"]["lower"].is_null());
}

// Everybody's function passes through 1/2 at level 3, and some are steeper: whoever answers 1 more often below
// does so less often above. R lme4's word for it is a singular fit with a correlation of -1.
TEST(GlmmStatistic, NamesTheCorrelationThatIsAtItsEnd) {
  const nlohmann::ordered_json asked = {
      {"data",
       {{"examinee", {"a", "a", "a", "a", "a", "b", "b", "b", "b", "b", "c", "c", "c", "c", "c"}},
        {"level", {1, 2, 3, 4, 5, 1, 2, 3, 4, 5, 1, 2, 3, 4, 5}},
        {"correct", {1, 5, 20, 35, 39, 10, 15, 20, 25, 30, 4, 10, 20, 30, 36}},
        {"trials", {40, 40, 40, 40, 40, 40, 40, 40, 40, 40, 40, 40, 40, 40, 40}}}},
      {"random", "slope"}};
  const Outcome outcome = run_statistic("glmm", asked);
  EXPECT_EQ(outcome.json["convergence"]["singular"], true);
  EXPECT_NEAR(outcome.json["between_examinees"]["correlation"], -1, 1e-9);
  EXPECT_GT(outcome.json["between_examinees"]["slope_sd"], 0.1);
  EXPECT_THAT(outcome.text, HasSubstr("The correlation between examinees is estimated as -1, the least"));
  EXPECT_THAT(outcome.text, testing::Not(HasSubstr("estimated as 0")));
}
