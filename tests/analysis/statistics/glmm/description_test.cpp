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
