#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "analysis/statistics/psychometric/merge_bootstrap.hpp"
#include "tests/analysis/support/ask.hpp"

using namespace palpate::analysis;
using nlohmann::ordered_json;
using testing::HasSubstr;

namespace {

ordered_json asked(const std::vector<double>& levels, const std::vector<long>& correct, long trials) {
  const std::vector<long> all(levels.size(), trials);
  return {{"data", {{"level", levels}, {"correct", correct}, {"trials", all}}}};
}

ordered_json example() {
  return asked({0, 2, 4, 6, 8, 10}, {26, 30, 38, 46, 50, 49}, 50);
}

// As files: the text of the JSON is all that comes back.
std::vector<ordered_json> shards_of(ordered_json request, long n) {
  std::vector<ordered_json> shards;
  for (long k = n; k >= 1; --k) {
    request["shard"] = std::to_string(k) + "/" + std::to_string(n);
    shards.push_back(ordered_json::parse(run_statistic("psychometric", request).json.dump()));
  }
  return shards;
}

std::string refusal_to_merge(const std::vector<ordered_json>& shards) {
  try {
    merge_bootstrap(shards);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST(PsychometricStatistic, MergedShardsHaveTheBitsOfOneRun) {
  for (const char* kind : {"parametric", "nonparametric"}) {
    for (const char* shape : {"logistic", "weibull"}) {
      // few answers at positive levels: some replicates are separable, some do not rise
      ordered_json request = asked({1, 2, 3, 4, 5}, {6, 5, 7, 9, 10}, 10);
      request.update({{"intervals", "bootstrap"},
                      {"bootstrap", kind},
                      {"replicates", 500},
                      {"shape", shape},
                      {"seed", 9}});
      const Outcome whole = run_statistic("psychometric", request);
      EXPECT_GT(whole.json["bootstrap"]["separable"].get<long>(), 0);
      for (const long n : {1L, 3L, 7L}) {
        const Outcome merged = merge_bootstrap(shards_of(request, n));
        EXPECT_EQ(merged.json.dump(), whole.json.dump());
        EXPECT_EQ(merged.text, whole.text);
      }
    }
  }
}

TEST(PsychometricStatistic, DoesNotMergeWhatDoesNotBelongTogether) {
  ordered_json request = example();
  request["replicates"] = 300;
  auto shards = shards_of(request, 3);
  EXPECT_EQ(refusal_to_merge(shards), "");
  auto missing = shards;
  missing.pop_back();
  EXPECT_THAT(refusal_to_merge(missing), HasSubstr("expected: number 1 next"));
  missing = {shards[1], shards[2]};
  EXPECT_THAT(refusal_to_merge(missing), HasSubstr("200 of 300 replicates; a shard is missing"));
  auto twice = shards;
  twice.push_back(shards[0]);
  EXPECT_THAT(refusal_to_merge(twice), HasSubstr("expected: number 301 next"));
  request["seed"] = 2;
  shards[0] = shards_of(request, 3)[0];
  EXPECT_THAT(refusal_to_merge(shards), HasSubstr("another request"));
  EXPECT_THAT(refusal_to_merge({run_statistic("psychometric", example()).json}),
              HasSubstr("not the result of a shard"));
  EXPECT_THAT(refusal_to_merge({}), HasSubstr("no shards"));
}

TEST(PsychometricStatistic, SaysAsAValueWhyThereIsNoFunction) {
  const auto json = [](const ordered_json& request) { return run_statistic("psychometric", request).json; };
  const ordered_json separable = json(asked({1, 2, 3, 4}, {5, 5, 10, 10}, 10));
  EXPECT_EQ(separable["status"], "separable");
  EXPECT_THAT(separable["why"].get<std::string>(), HasSubstr("between levels 2 and 3"));
  EXPECT_TRUE(separable["slope"]["estimate"].is_null());
  EXPECT_TRUE(separable["bootstrap"].is_null());
  EXPECT_EQ(json(asked({1, 2, 3, 4}, {10, 10, 10, 10}, 10))["status"], "no rise");
  const ordered_json two = json(asked({1, 2}, {5, 9}, 10));
  EXPECT_EQ(two["status"], "unfit levels");
  EXPECT_THAT(two["why"].get<std::string>(), HasSubstr("2 distinct levels for 3 free parameters"));
  ordered_json zero = example();
  zero["shape"] = "weibull";
  EXPECT_EQ(json(zero)["status"], "unfit levels");
  EXPECT_THAT(json(zero)["why"].get<std::string>(), HasSubstr("Weibull function starts at level 0"));
  zero["shape"] = "logistic";
  zero["shard"] = "1/2";
  EXPECT_EQ(json(zero)["status"], "fitted");
}

TEST(PsychometricStatistic, GivesPseJndAndWeberFraction) {
  // Without guesses and lapses the logistic's JND is log(3)/beta; beta and alpha of R's glm as in
  // fit_test.cpp
  ordered_json request = asked({0, 1, 2, 3, 4}, {5, 14, 24, 40, 45}, 50);
  request.update({{"guess", 0}, {"lapse", "0"}, {"standard", 2}});
  const ordered_json json = run_statistic("psychometric", request).json;
  EXPECT_NEAR(json["pse"]["estimate"].get<double>(), 1.9325649046, 1e-8);
  EXPECT_NEAR(json["jnd"]["estimate"].get<double>(), std::log(3.0) / 1.11833336371, 1e-8);
  EXPECT_NEAR(json["weber_fraction"]["estimate"].get<double>(), std::log(3.0) / 1.11833336371 / 2, 1e-8);
  EXPECT_NEAR(json["log_likelihood"].get<double>(), -9.99469743134, 1e-9);  // R: logLik of the same glm
  ordered_json forced = example();
  forced["standard"] = 2;
  const ordered_json choice = run_statistic("psychometric", forced).json;
  EXPECT_TRUE(choice["pse"].is_null());
  EXPECT_NEAR(choice["jnd"]["estimate"].get<double>(), choice["threshold"]["estimate"].get<double>() - 2,
              1e-12);
  forced.erase("standard");
  EXPECT_TRUE(run_statistic("psychometric", forced).json["jnd"].is_null());
}

TEST(PsychometricStatistic, NamesTheLevelThatItCallsThreshold) {
  ordered_json request = example();
  request["threshold-at"] = 0.75;
  const ordered_json json = run_statistic("psychometric", request).json;
  const double alpha = json["alpha"], beta = json["beta"], lapse = json["lapse"]["estimate"];
  EXPECT_NEAR(json["threshold"]["estimate"].get<double>(), alpha + std::log(3.0) / beta, 1e-12);
  EXPECT_NEAR(json["threshold"]["psi"].get<double>(), 0.5 + (0.5 - lapse) * 0.75, 1e-12);
  EXPECT_NEAR(json["slope"]["estimate"].get<double>(), beta * 0.75 * 0.25, 1e-12);
  EXPECT_NEAR(json["slope"]["of_psi"].get<double>(), (0.5 - lapse) * beta * 0.75 * 0.25, 1e-12);
}

TEST(PsychometricStatistic, HoldsAFixedLapseRate) {
  ordered_json request = example();
  request["lapse"] = "0.02";
  const ordered_json json = run_statistic("psychometric", request).json;
  EXPECT_EQ(json["lapse"]["estimate"], 0.02);
  EXPECT_FALSE(json["lapse"]["free"].get<bool>());
  EXPECT_EQ(json["deviance"]["degrees_of_freedom"], 4);
}

TEST(PsychometricStatistic, RefusesWhatItCannotUse) {
  const auto refusal = [](const std::string& name, const ordered_json& value) {
    ordered_json request = example();
    request[name] = value;
    return refusal_of("psychometric", request);
  };
  EXPECT_THAT(refusal("lapse", "some"), HasSubstr("lapse is 'some'; accepted: free, or a number"));
  EXPECT_THAT(refusal("guess", 1), HasSubstr("guess is 1"));
  EXPECT_THAT(refusal("lapse-max", 0.5), HasSubstr("their sum must stay below 1"));
  EXPECT_THAT(refusal("threshold-at", 1), HasSubstr("threshold-at is 1"));
  EXPECT_THAT(refusal("replicates", 10), HasSubstr("replicates is 10; accepted: 199"));
  EXPECT_THAT(refusal("standard", -1), HasSubstr("needs a standard above 0"));
  for (const char* wrong : {"0/4", "5/4", "2", "a/b", "2/"})
    EXPECT_THAT(refusal("shard", wrong), HasSubstr("K/N"));
  ordered_json impossible = example();
  impossible["data"]["correct"][0] = 51;
  EXPECT_THAT(refusal_of("psychometric", impossible), HasSubstr("51 correct answers of 50 trials"));
}

TEST(PsychometricBayesStatistic, SaysAsAValueWhyThereIsNoFunction) {
  ordered_json request = asked({2}, {5}, 10);
  EXPECT_EQ(run_statistic("psychometric-bayes", request).json["status"], "unfit levels");
  request["guess"] = "some";
  EXPECT_THAT(refusal_of("psychometric-bayes", request), HasSubstr("guess is 'some'; accepted: free"));
}

TEST(PsychometricStatistic, TakesBlocksOfOneLevelTogetherForTheChiSquaredDistribution) {
  const std::vector<int> correct{26, 30, 38, 46, 49, 50};
  nlohmann::ordered_json single = {{"level", {}}, {"correct", {}}, {"trials", {}}}, pooled = single;
  for (int level = 1; level <= 6; ++level) {
    pooled["level"].push_back(level);
    pooled["correct"].push_back(correct[level - 1]);
    pooled["trials"].push_back(50);
    for (int trial = 0; trial < 50; ++trial) {
      single["level"].push_back(level);
      single["correct"].push_back(trial < correct[level - 1] ? 1 : 0);
      single["trials"].push_back(1);
    }
  }
  const Outcome one = run_statistic("psychometric", {{"data", single}, {"replicates", 0}});
  const Outcome all = run_statistic("psychometric", {{"data", pooled}, {"replicates", 0}});
  EXPECT_TRUE(one.json["deviance"]["p_chi_squared"].is_null());
  EXPECT_NEAR(one.json["deviance"]["by_level"]["p_chi_squared"], all.json["deviance"]["p_chi_squared"], 1e-9);
  EXPECT_EQ(one.json["deviance"]["by_level"]["degrees_of_freedom"], 3);
  EXPECT_THAT(one.text, HasSubstr("does not hold for one trial a block on the average"));
  EXPECT_TRUE(all.json["deviance"]["by_level"].is_null());
}

TEST(PsychometricBayesStatistic, SaysThatAnswersDoNotRise) {
  const auto asked = [](const nlohmann::ordered_json& correct, const char* guess) {
    return nlohmann::ordered_json{
        {"data", {{"level", {1, 2, 3, 4, 5}}, {"correct", correct}, {"trials", {10, 10, 10, 10, 10}}}},
        {"guess", guess}};
  };
  for (const char* guess : {"1/2", "0", "free"}) {
    const Outcome falling = run_statistic("psychometric-bayes", asked({10, 9, 7, 6, 5}, guess));
    EXPECT_EQ(falling.json["status"], "no rise") << guess;
    EXPECT_THAT(falling.text, HasSubstr("No rise: the answers do not rise with the level")) << guess;
    const Outcome rising = run_statistic("psychometric-bayes", asked({5, 6, 7, 9, 10}, guess));
    EXPECT_EQ(rising.json["status"], "fitted") << guess;
    EXPECT_TRUE(rising.json["why"].is_null());
  }
}
