#include "analysis/statistics/statistics.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <stdexcept>

#include "analysis/description/read_number.hpp"
#include "analysis/description/statistic.hpp"
#include "tests/analysis/support/ask.hpp"

using namespace palpate::analysis;
using testing::HasSubstr;
using testing::SizeIs;

namespace {

// Every statistic keeps what its description promises, whoever wrote it.
class EveryStatistic : public testing::TestWithParam<std::string> {
 protected:
  const Statistic& statistic() const { return statistic_named(GetParam()); }
};

std::vector<std::string> names() {
  std::vector<std::string> all;
  for (const Statistic& statistic : statistics()) all.push_back(statistic.name);
  return all;
}

}  // namespace

TEST_P(EveryStatistic, AnswersItsExampleWithTheOutputsThatItNames) {
  const Outcome outcome = run_statistic(GetParam(), statistic().example);
  std::set<std::string> found, promised = {"procedure", "method"};
  for (const auto& item : outcome.json.items()) found.insert(item.key());
  for (const Output& output : statistic().outputs) promised.insert(output.name);
  EXPECT_EQ(found, promised);
  EXPECT_EQ(outcome.json["procedure"], GetParam());
  EXPECT_TRUE(outcome.json["method"]["name"].is_string()) << outcome.json["method"];
  EXPECT_TRUE(outcome.json["method"]["source"].is_string()) << outcome.json["method"];
  EXPECT_GT(outcome.text.size(), 20U);
  EXPECT_EQ(outcome.text.back(), '\n');
}

TEST_P(EveryStatistic, AnswersTheSameAgain) {
  EXPECT_EQ(run_statistic(GetParam(), statistic().example).json,
            run_statistic(GetParam(), statistic().example).json);
}

TEST_P(EveryStatistic, RefusesWhatItDoesNotTake) {
  nlohmann::ordered_json asked = statistic().example;
  asked["colour"] = "red";
  EXPECT_THAT(refusal_of(GetParam(), asked), HasSubstr("takes no 'colour'"));
}

TEST_P(EveryStatistic, RefusesToGoWithoutWhatItNeeds) {
  for (const Input& input : statistic().inputs) {
    if (input.usual || input.optional || input.kind == Input::Kind::Switch) continue;
    nlohmann::ordered_json asked = statistic().example;
    asked.erase(input.name);
    EXPECT_THAT(refusal_of(GetParam(), asked), HasSubstr("needs " + input.name));
  }
  if (statistic().data.shape == Data::Shape::None || statistic().data.optional) return;
  nlohmann::ordered_json asked = statistic().example;
  asked.erase("data");
  EXPECT_THAT(refusal_of(GetParam(), asked), HasSubstr("needs data"));
}

TEST_P(EveryStatistic, RefusesWordsWhereNumbersBelong) {
  for (const Input& input : statistic().inputs) {
    if (input.kind == Input::Kind::Text) continue;
    nlohmann::ordered_json asked = statistic().example;
    asked[input.name] = "many";
    EXPECT_THAT(refusal_of(GetParam(), asked), HasSubstr(input.name + " is 'many'"));
  }
}

TEST_P(EveryStatistic, IsDescribedForItsReaders) {
  EXPECT_EQ(statistic().question.back(), '?');
  EXPECT_GT(statistic().teaches.size(), 60U);
  for (const Input& input : statistic().inputs) EXPECT_FALSE(input.meaning.empty()) << input.name;
  for (const Output& output : statistic().outputs) EXPECT_FALSE(output.meaning.empty()) << output.name;
}

INSTANTIATE_TEST_SUITE_P(Statistics, EveryStatistic, testing::ValuesIn(names()), [](const auto& parameter) {
  std::string name = parameter.param;
  std::ranges::replace(name, '-', '_');
  return name;
});

TEST(Statistics, AreListedByName) {
  const std::vector<std::string> all = names();
  EXPECT_TRUE(std::ranges::is_sorted(all));
  EXPECT_THAT(std::set(all.begin(), all.end()), SizeIs(all.size()));
}

TEST(Statistics, AskForOneThatThereIs) {
  try {
    statistic_named("anova");
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_THAT(error.what(), HasSubstr("there is no statistic 'anova'; accepted: " + names().front()));
  }
}

TEST(Arguments, TakeNumbersAsPeopleAndProgramsWriteThem) {
  const auto p = [](const nlohmann::ordered_json& asked) {
    return run_statistic("binomial", asked).json["p"].get<double>();
  };
  EXPECT_EQ(p({{"correct", 41}, {"trials", 60}}), p({{"correct", "41"}, {"trials", "60"}, {"chance", 0.5}}));
  EXPECT_EQ(run_statistic("mcnemar", {{"table", "794,86,150,570"}}).json,
            run_statistic("mcnemar", {{"table", {794, 86, 150, 570}}}).json);
  EXPECT_THAT(refusal_of("mcnemar", {{"table", "1,2,3"}}), HasSubstr("table has 3 counts; accepted: four"));
  EXPECT_THAT(refusal_of("mcnemar", {{"table", "1,2,3,"}}), HasSubstr("table is '1,2,3,'; accepted: whole"));
  EXPECT_THAT(refusal_of("binomial", {{"correct", 41.5}, {"trials", 60}}), HasSubstr("correct is 41.5"));
}

TEST(ReadNumber, TakesFractionsAndDecimals) {
  EXPECT_EQ(read_fraction("1/2"), 0.5);
  EXPECT_EQ(read_fraction("0.25"), 0.25);
  for (const char* wrong : {"", "1/", "/2", "1/0", "half", "1/2/3", "0,5", "1/2 ", "nan"}) {
    EXPECT_FALSE(read_fraction(wrong)) << wrong;
  }
}

TEST(ReadNumber, TakesWholeNumbers) {
  EXPECT_EQ(read_count("+60"), 60);
  for (const char* wrong : {"", "1.5", "+-1", "99999999999999999999", "1 ", "-1", "1000000001"}) {
    EXPECT_FALSE(read_count(wrong)) << wrong;
  }
  EXPECT_EQ(read_count("1000000000"), 1'000'000'000);
  EXPECT_EQ(read_seed("9223372036854775807"), 9'223'372'036'854'775'807);
  EXPECT_FALSE(read_seed("-1"));
}

// Their squares, and the sums of these, must be numbers.
TEST(ReadNumber, TakesNumbersThatResultsAreMadeOf) {
  for (const char* right : {"0", "-0", "1e150", "-1e-150", "0.25"}) EXPECT_TRUE(read_number(right)) << right;
  for (const char* wrong : {"1.1e150", "-1e308", "9e-151", "3e-320", "1e999", "inf", "nan", ""}) {
    EXPECT_FALSE(read_number(wrong)) << wrong;
    EXPECT_FALSE(read_fraction(wrong)) << wrong;
  }
  EXPECT_FALSE(read_fraction("1e100/1e-100"));
  EXPECT_EQ(read_finite("1e-200"), 1e-200);
}

TEST(ReadNumber, KnowsNumeralsThatAreNoUsableNumbers) {
  for (const char* numeral : {"1", "+1e999", "-1e-999", "1e308"}) EXPECT_TRUE(is_numeral(numeral)) << numeral;
  for (const char* word : {"", "nan", "level", "1x", "1;2"}) EXPECT_FALSE(is_numeral(word)) << word;
}

TEST(Arguments, TakePValuesAsSmallAsTheyCome) {
  EXPECT_EQ(run_statistic("adjust", {{"p", {1e-200, 0.5}}}).json["holm"][0], 2e-200);
  EXPECT_EQ(run_statistic("adjust", {{"data", {{"p", {"1e-200", "0.5"}}}}}).json["holm"][0], 2e-200);
}
