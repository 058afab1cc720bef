#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/analysis/support/ask.hpp"

using namespace palpate::analysis;
using testing::HasSubstr;

TEST(DPrimeStatistic, StillTakesTwoIntervalsForTheUsual) {
  const Outcome outcome = run_statistic("dprime", {{"correct", 41}, {"trials", 60}});
  EXPECT_EQ(outcome.json["task"], "2IFC");
  EXPECT_EQ(outcome.json["chance"], 0.5);
  EXPECT_NEAR(outcome.json["d_prime"], 0.674637043770044, 1e-12);  // R 4.2: sqrt(2)*qnorm(41/60)
}

TEST(DPrimeStatistic, TakesTheTaskAndWhatBelongsToIt) {
  const Outcome four =
      run_statistic("dprime", {{"correct", 45}, {"trials", 60}, {"task", "m-AFC"}, {"alternatives", 4}});
  EXPECT_NEAR(four.json["d_prime"], 1.68, 0.005);  // Hacker & Ratcliff 1979
  EXPECT_EQ(four.json["chance"], 0.25);
  const nlohmann::ordered_json abx = {{"correct", 45}, {"trials", 60}, {"task", "ABX"}};
  EXPECT_THAT(refusal_of("dprime", abx), HasSubstr("ABX needs a strategy"));
  EXPECT_THAT(refusal_of("dprime", {{"correct", 4}, {"trials", 6}, {"task", "m-AFC"}}),
              HasSubstr("m-AFC needs alternatives"));
}

TEST(DPrimeStatistic, SaysThatBelowChanceThereIsNothingToFind) {
  const Outcome outcome = run_statistic("dprime", {{"correct", 15}, {"trials", 60}, {"task", "triangle"}});
  EXPECT_EQ(outcome.json["d_prime"], 0.0);
  EXPECT_TRUE(outcome.json["standard_error"].is_null());
  EXPECT_THAT(outcome.text, HasSubstr("No more than the 33.3 % that guessing gives: d' is 0."));
  EXPECT_THAT(outcome.text, HasSubstr("standard error none"));
}

TEST(CountPairs, AskForTwo) {
  EXPECT_THAT(refusal_of("yes-no", {{"signal", "20"}, {"noise", "8,30"}}),
              HasSubstr("signal has 1 count; accepted: two, a part and its whole"));
  EXPECT_THAT(refusal_of("yes-no", {{"signal", "31,30"}, {"noise", "8,30"}}),
              HasSubstr("31 correct answers of 30"));
}

TEST(YesNoStatistic, SaysWhichAnswerIsFavoured) {
  EXPECT_THAT(run_statistic("yes-no", {{"signal", "20,30"}, {"noise", "3,30"}}).text,
              HasSubstr("\"no\" is favoured"));
  EXPECT_THAT(run_statistic("yes-no", {{"signal", "28,30"}, {"noise", "15,30"}}).text,
              HasSubstr("\"yes\" is favoured"));
}

TEST(SimilarityStatistic, TakesItsBoundOnce) {
  nlohmann::ordered_json asked = {{"correct", 22}, {"trials", 66}, {"chance", "1/3"}};
  EXPECT_THAT(refusal_of("similarity", asked), HasSubstr("needs its bound once"));
  asked["proportion"] = 0.6;
  EXPECT_NEAR(run_statistic("similarity", asked).json["bound_discriminators"], 0.4, 1e-12);
  asked["discriminators"] = 0.4;
  EXPECT_THAT(refusal_of("similarity", asked), HasSubstr("needs its bound once"));
}

TEST(SimilarityStatistic, DoesNotTakeSilenceForSimilarity) {
  const Outcome outcome =
      run_statistic("similarity", {{"correct", 34}, {"trials", 60}, {"discriminators", "0.2"}});
  EXPECT_EQ(outcome.json["similar"], false);
  EXPECT_THAT(outcome.text, HasSubstr("that does not show a difference either"));
}

TEST(BayesStatistic, SaysWhatSpeaksForWhat) {
  EXPECT_THAT(run_statistic("bayes", {{"correct", 31}, {"trials", 60}}).text,
              HasSubstr("5.038 times as likely under chance as under the prior"));  // 1/0.198474612550378
  EXPECT_THAT(refusal_of("bayes", {{"correct", 31}, {"trials", 60}, {"prior", "1"}}),
              HasSubstr("prior has 1 number; accepted: two"));
}

TEST(AdjustStatistic, TakesPValuesFromOnePlace) {
  const nlohmann::ordered_json data = {{"p", {0.01, 0.02}}};
  EXPECT_EQ(run_statistic("adjust", {{"data", data}}).json["holm"],
            run_statistic("adjust", {{"p", "0.01,0.02"}}).json["holm"]);
  EXPECT_THAT(refusal_of("adjust", {{"p", "0.01"}, {"data", data}}), HasSubstr("once"));
  EXPECT_THAT(refusal_of("adjust", nlohmann::ordered_json::object()), HasSubstr("once"));
}

TEST(MatrixStatistics, NameTheirColumns) {
  const nlohmann::ordered_json data = {
      {"soft", {0, 1, 0, 1}}, {"hard", {1, 1, 1, 0}}, {"none", {0, 0, 0, 1}}};
  EXPECT_EQ(run_statistic("cochran", {{"data", data}}).json["columns"][1]["name"], "hard");
  EXPECT_EQ(run_statistic("friedman", {{"data", data}}).json["columns"][2]["name"], "none");
  // Cochran's Q is Friedman's statistic of the same 0 and 1, ties corrected [Cochran1950].
  EXPECT_NEAR(run_statistic("cochran", {{"data", data}}).json["q"],
              run_statistic("friedman", {{"data", data}}).json["chi_squared"], 1e-12);
  EXPECT_THAT(refusal_of("cochran", {{"data", {{"a", {0, 2}}, {"b", {1, 0}}}}}),
              HasSubstr("data:2: a is '2'; accepted: 0 or 1"));
}
