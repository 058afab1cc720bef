// What tables and batch lines `palpate stats` takes, and how it names what it cannot take.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/end_to_end/program.hpp"
#include "tests/end_to_end/with_files.hpp"

namespace palpate::test {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;

class StatsInput : public WithFiles {};

}  // namespace

// toJSON() of R's jsonlite writes one value as an array of one; numbers are numbers wherever one is accepted.
TEST_F(StatsInput, ABatchTakesWhatScriptsWrite) {
  const Outcome outcome =
      run({"stats", "batch", file("batch.jsonl", R"({"procedure":["critical"],"trials":[60]}
{"procedure":"critical","trials":60}
{"procedure":"psychometric","replicates":0,"lapse":0.02,"data":{"level":[0,2,4],"correct":[26,38,49],"trials":[50,50,50]}}
{"procedure":"psychometric","replicates":0,"lapse":"0.02","data":{"level":[0,2,4],"correct":[26,38,49],"trials":[50,50,50]}})")});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  const std::vector<json> lines = lines_of(outcome.out);
  ASSERT_EQ(lines.size(), 4U);
  EXPECT_EQ(lines[0], lines[1]);
  EXPECT_EQ(lines[2], lines[3]);
}

TEST_F(StatsInput, ABatchNamesWhatItCannotTake) {
  const Outcome outcome = run({"stats", "batch", file("batch.jsonl", R"({"procedure":"critical","trials":NaN}
{"procedure":"critical","trials":[60,61]}
{"procedure":"critical","trials":60,"trials":61}
{"procedure":7}
{"procedure":"ttest","data":{"difference":5}}
{"procedure":"ttest","data":{"difference":[[1],2]}}
{"procedure":"critical","trials":1e999})")});
  EXPECT_EQ(outcome.exit_code, 1);
  const std::vector<json> lines = lines_of(outcome.out);
  ASSERT_EQ(lines.size(), 7U);
  EXPECT_THAT(lines[0]["error"], HasSubstr("no JSON at character 34: 'NaN'; accepted: finite numbers"));
  EXPECT_THAT(lines[1]["error"], HasSubstr("trials is the array [60,61]; accepted: a whole number"));
  EXPECT_THAT(lines[2]["error"], HasSubstr("the key \"trials\" is there twice"));
  EXPECT_THAT(lines[3]["error"], HasSubstr("\"procedure\" is 7; accepted: a text"));
  EXPECT_THAT(lines[4]["error"], HasSubstr("data.difference is 5; accepted: an array"));
  EXPECT_THAT(lines[5]["error"], HasSubstr("data.difference holds the array [1]"));
  EXPECT_THAT(outcome.out, testing::Not(HasSubstr("json.exception")));
}

// What is said about a row says where it stands, also when a statistic says it.
TEST_F(StatsInput, EveryMessageAboutARowHasItsLine) {
  const auto refusal = [&](const char* statistic, const std::string& text) {
    const Outcome outcome = run({"stats", statistic, file("rows.csv", text)});
    EXPECT_EQ(outcome.exit_code, 1) << statistic;
    return outcome.err;
  };
  EXPECT_THAT(refusal("psychometric", "level,correct,trials\n0.5,26,50\n1.5,0,0\n"),
              HasSubstr("rows.csv:3: 0 trials; at least 1 is needed"));
  EXPECT_THAT(refusal("stevens", "examinee,level,estimate\nP1,1,2\nP1,2,0\n"),
              HasSubstr("rows.csv:3: level 2 was judged 0"));
  EXPECT_THAT(refusal("bradley-terry", "winner,loser\na,b\n\nb,b\n"),
              HasSubstr("rows.csv:4: 'b' is compared"));
  EXPECT_THAT(refusal("cochran", "a,b\n0,1\n1,2\n"), HasSubstr("rows.csv:3: b is '2'; accepted: 0 or 1"));
  EXPECT_THAT(refusal("glmm", "examinee,level,response\nP1,1,yes\n"),
              HasSubstr("rows.csv:2: response is 'yes'; accepted: 0 or 1 (also written as false or true)"));
  EXPECT_THAT(refusal("adjust", "p\n0.1\n1.5\n"),
              HasSubstr("rows.csv:3: p is '1.5'; accepted: a number from 0 to 1"));
  EXPECT_THAT(refusal("randomisation", "trials,correct_first,answers_first,correct\n4,2,2,4\n4,2,2,3\n"),
              HasSubstr("rows.csv:3: a stratum of 4 trials"));
}

TEST_F(StatsInput, ATableWithoutAHeaderIsNeverInSilence) {
  const std::string matrix =
      file("matrix.csv", "1,5,10\n2.1,2.6,3.0\n1.8,2.0,2.4\n2.5,2.4,2.9\n1.9,2.3,2.2\n");
  const Outcome guessed = run({"stats", "friedman", matrix, "--format", "json"});
  EXPECT_THAT(guessed.err, HasSubstr("matrix.csv: line 1 was taken as data (no header)"));
  EXPECT_EQ(json::parse(guessed.out)["n"], 5);
  // R: friedman.test(rbind(c(2.1,2.6,3),c(1.8,2,2.4),c(2.5,2.4,2.9),c(1.9,2.3,2.2)))$statistic: 4.5
  const Outcome named = run({"stats", "friedman", matrix, "--header", "--format", "json"});
  EXPECT_THAT(named.err, IsEmpty());
  EXPECT_NEAR(json::parse(named.out)["chi_squared"].get<double>(), 4.5, 1e-12);
  EXPECT_THAT(run({"stats", "friedman", matrix, "--no-header"}).err, IsEmpty());
  EXPECT_EQ(run({"stats", "friedman", matrix, "--no-header", "--header"}).exit_code, 2);
}

TEST_F(StatsInput, OnlyALevelOfOneIsAHundredPercent) {
  const Outcome outcome =
      run({"stats", "ttest", file("d.csv", "difference\n1\n2\n4\n"), "--level", "0.99999"});
  EXPECT_THAT(outcome.out, AllOf(HasSubstr("99.999 % interval"), testing::Not(HasSubstr("100 %"))));
}

}  // namespace palpate::test
