#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <stdexcept>

#include "analysis/procedures/procedure.hpp"
#include "analysis/procedures/read_number.hpp"
#include "tests/analysis/procedures/support.hpp"

using namespace palpate::analysis;
using testing::HasSubstr;
using testing::SizeIs;

namespace {

// Every procedure keeps what its description promises, whoever wrote it.
class EveryProcedure : public testing::TestWithParam<std::string> {
 protected:
  const Procedure& procedure() const { return procedure_named(GetParam()); }
};

std::vector<std::string> names() {
  std::vector<std::string> all;
  for (const Procedure& procedure : procedures()) all.push_back(procedure.name);
  return all;
}

}  // namespace

TEST_P(EveryProcedure, AnswersItsExampleWithTheOutputsThatItNames) {
  const Outcome outcome = run_procedure(GetParam(), procedure().example);
  std::set<std::string> found, promised = {"procedure", "method"};
  for (const auto& item : outcome.json.items()) found.insert(item.key());
  for (const Output& output : procedure().outputs) promised.insert(output.name);
  EXPECT_EQ(found, promised);
  EXPECT_EQ(outcome.json["procedure"], GetParam());
  EXPECT_TRUE(outcome.json["method"]["name"].is_string()) << outcome.json["method"];
  EXPECT_TRUE(outcome.json["method"]["source"].is_string()) << outcome.json["method"];
  EXPECT_GT(outcome.text.size(), 20U);
  EXPECT_EQ(outcome.text.back(), '\n');
}

TEST_P(EveryProcedure, AnswersTheSameAgain) {
  EXPECT_EQ(run_procedure(GetParam(), procedure().example).json,
            run_procedure(GetParam(), procedure().example).json);
}

TEST_P(EveryProcedure, RefusesWhatItDoesNotTake) {
  nlohmann::ordered_json asked = procedure().example;
  asked["colour"] = "red";
  EXPECT_THAT(refusal_of(GetParam(), asked), HasSubstr("takes no 'colour'"));
}

TEST_P(EveryProcedure, RefusesToGoWithoutWhatItNeeds) {
  for (const Input& input : procedure().inputs) {
    if (input.usual || input.optional || input.kind == Input::Kind::Switch) continue;
    nlohmann::ordered_json asked = procedure().example;
    asked.erase(input.name);
    EXPECT_THAT(refusal_of(GetParam(), asked), HasSubstr("needs " + input.name));
  }
  if (procedure().data.shape == Data::Shape::None || procedure().data.optional) return;
  nlohmann::ordered_json asked = procedure().example;
  asked.erase("data");
  EXPECT_THAT(refusal_of(GetParam(), asked), HasSubstr("needs data"));
}

TEST_P(EveryProcedure, RefusesWordsWhereNumbersBelong) {
  for (const Input& input : procedure().inputs) {
    if (input.kind == Input::Kind::Text) continue;
    nlohmann::ordered_json asked = procedure().example;
    asked[input.name] = "many";
    EXPECT_THAT(refusal_of(GetParam(), asked), HasSubstr(input.name + " is 'many'"));
  }
}

TEST_P(EveryProcedure, IsDescribedForItsReaders) {
  EXPECT_EQ(procedure().question.back(), '?');
  EXPECT_GT(procedure().teaches.size(), 60U);
  for (const Input& input : procedure().inputs) EXPECT_FALSE(input.meaning.empty()) << input.name;
  for (const Output& output : procedure().outputs) EXPECT_FALSE(output.meaning.empty()) << output.name;
}

INSTANTIATE_TEST_SUITE_P(Procedures, EveryProcedure, testing::ValuesIn(names()), [](const auto& parameter) {
  std::string name = parameter.param;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

TEST(Procedures, AreListedByName) {
  const std::vector<std::string> all = names();
  EXPECT_TRUE(std::is_sorted(all.begin(), all.end()));
  EXPECT_THAT(std::set(all.begin(), all.end()), SizeIs(all.size()));
}

TEST(Procedures, AskForOneThatThereIs) {
  try {
    procedure_named("anova");
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_THAT(error.what(), HasSubstr("there is no procedure 'anova'; accepted: " + names().front()));
  }
}

TEST(Arguments, TakeNumbersAsPeopleAndProgramsWriteThem) {
  const auto p = [](const nlohmann::ordered_json& asked) {
    return run_procedure("binomial", asked).json["p"].get<double>();
  };
  EXPECT_EQ(p({{"correct", 41}, {"trials", 60}}), p({{"correct", "41"}, {"trials", "60"}, {"chance", 0.5}}));
  EXPECT_EQ(run_procedure("mcnemar", {{"table", "794,86,150,570"}}).json,
            run_procedure("mcnemar", {{"table", {794, 86, 150, 570}}}).json);
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
  EXPECT_EQ(run_procedure("adjust", {{"p", {1e-200, 0.5}}}).json["holm"][0], 2e-200);
  EXPECT_EQ(run_procedure("adjust", {{"data", {{"p", {"1e-200", "0.5"}}}}}).json["holm"][0], 2e-200);
}
