// `palpate stats` as a person and as a script use it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <nlohmann/json.hpp>

#include "tests/end_to_end/program.hpp"
#include "tests/end_to_end/with_files.hpp"
#include "tests/support/places.hpp"

namespace palpate::test {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;

class Stats : public WithFiles {};

std::string text_of(const std::string& path) {
  std::ifstream in(path);
  return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace

// What a person types and what a script writes are one procedure.
TEST_F(Stats, OptionsCsvAndJsonLinesGiveTheSameResult) {
  const std::string column = file("differences.csv", "difference\n1\n2\n3\n-1\n");
  const Outcome typed = run({"stats", "sign", column, "--side", "greater", "--format", "json"});
  ASSERT_EQ(typed.exit_code, 0) << typed.err;
  const std::string batch =
      file("batch.jsonl", R"({"procedure": "sign", "side": "greater", "file": ")" + column +
                              R"("}
{"procedure": "sign", "side": "greater", "data": {"difference": [1, 2, 3, -1]}})");
  const Outcome scripted = run({"stats", "batch", batch});
  ASSERT_EQ(scripted.exit_code, 0) << scripted.err;
  for (const json& line : lines_of(scripted.out)) EXPECT_EQ(line, json::parse(typed.out));
}

TEST_F(Stats, ALineMayNameItsStatisticUnderEitherKey) {
  const Outcome outcome =
      run({"stats", "batch", file("batch.jsonl", R"({"procedure": "critical", "trials": 60}
{"statistic": "critical", "trials": 60}
{"procedure": "critical", "statistic": "critical", "trials": 60})")});
  const std::vector<json> lines = lines_of(outcome.out);
  ASSERT_EQ(lines.size(), 3U);
  EXPECT_EQ(lines[0], lines[1]);
  EXPECT_EQ(lines[1]["procedure"], "critical");
  EXPECT_THAT(lines[2]["error"], HasSubstr("one of them is accepted"));
}

TEST_F(Stats, ALineThatCannotBeAnsweredLosesNoOther) {
  const std::string batch =
      file("batch.jsonl", R"({"procedure": "binomial", "correct": 37, "trials": 60, "id": "a"}
oops
{"procedure": "binomial", "correct": 70, "trials": 60, "id": "c"}

{"procedure": "critical", "trials": 60, "id": "e"})");
  const Outcome outcome = run({"stats", "batch", batch});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_THAT(outcome.err, HasSubstr("2 lines could not be answered"));
  const std::vector<json> lines = lines_of(outcome.out);
  ASSERT_EQ(lines.size(), 4U);
  EXPECT_NEAR(lines[0]["p"].get<double>(), 0.04623049,
              1e-8);  // R: binom.test(37, 60, alternative = "greater")
  EXPECT_EQ(lines[0]["id"], "a");
  EXPECT_EQ(lines[1]["line"], 2);
  EXPECT_EQ(lines[2]["id"], "c");
  EXPECT_EQ(lines[2]["error"], "70 correct answers of 60 trials; accepted: 0 to 60");
  EXPECT_EQ(lines[3]["at_least"], 37);
}

TEST_F(Stats, SaysWhatIsWrongAndWhatIsAccepted) {
  const Outcome word = run({"stats", "binomial", "--correct", "many", "--trials", "60"});
  EXPECT_EQ(word.exit_code, 1);
  EXPECT_THAT(word.err, HasSubstr("correct is 'many'; accepted: a whole number"));
  EXPECT_THAT(word.out, IsEmpty());
  const Outcome missing = run({"stats", "binomial", "--trials", "60"});
  EXPECT_EQ(missing.exit_code, 2);
  EXPECT_THAT(missing.err, HasSubstr("--correct is required"));
  const Outcome column = run({"stats", "sign", file("bad.csv", "difference\n1\nx\n")});
  EXPECT_EQ(column.exit_code, 1);
  EXPECT_THAT(column.err, HasSubstr("bad.csv:3: difference is 'x'"));
}

// Whatever is thrown over a line, and whatever bytes it holds.
TEST_F(Stats, NoLineEndsTheBatch) {
  const std::string good = R"({"procedure": "critical", "trials": 60})";
  const std::string batch =
      file("batch.jsonl", R"({"procedure": "ttest", "data": {"difference": [1e308, 1]}})"
                          "\n{\"id\": \"\xE9\"}\n" +
                              std::string(100'000, '[') + "\n" +
                              R"({"procedure": "randomisation", "id": 4, "data":)"
                              R"( {"trials": [1e9], "correct_first": [0],)"
                              R"( "answers_first": [0], "correct": [0]}})"
                              "\n" +
                              good + "\n");
  const Outcome outcome = run({"stats", "batch", batch});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_THAT(outcome.err, HasSubstr("4 lines could not be answered"));
  const std::vector<json> lines = lines_of(outcome.out);
  ASSERT_EQ(lines.size(), 5U);
  for (std::size_t k = 0; k < 4; ++k) EXPECT_EQ(lines[k]["line"], k + 1);
  EXPECT_EQ(lines[3]["id"], 4);
  EXPECT_EQ(lines[4]["at_least"], 37);
}

TEST_F(Stats, ABatchIsNoFolder) {
  const Outcome outcome = run({"stats", "batch", std::filesystem::temp_directory_path()});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_THAT(outcome.err, HasSubstr("is a folder; a file of JSON lines is accepted"));
}

// Before, they ended in Boost's own words, in "infinite", without memory, or not within a minute.
TEST_F(Stats, RefusesNumbersThatNoResultIsMadeOf) {
  const auto refusal = [](const std::vector<std::string>& arguments) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.exit_code, 1) << outcome.err;
    EXPECT_THAT(outcome.out, IsEmpty());
    return outcome.err;
  };
  const std::string magnitudes = "0, or of magnitude 1e-150 to 1e150";
  EXPECT_THAT(refusal({"stats", "ttest", file("large.csv", "difference\n1e308\n1\n")}),
              AllOf(HasSubstr("large.csv:2: difference is '1e308'"), HasSubstr(magnitudes)));
  EXPECT_THAT(refusal({"stats", "ttest", file("small.csv", "1\n2\n3e-320\n")}),
              AllOf(HasSubstr("small.csv:3: the value is '3e-320'"), HasSubstr(magnitudes)));
  EXPECT_THAT(refusal({"stats", "permutation", file("first.csv", "-1e308\n1e999\n")}),
              HasSubstr("first.csv:1: the value is '-1e308'"));
  const std::string most = std::to_string(std::numeric_limits<long>::max());
  EXPECT_THAT(refusal({"stats", "binomial", "--correct", most, "--trials", most}),
              HasSubstr("correct is '" + most + "'; accepted: a whole number from 0 to 1000000000"));
  EXPECT_THAT(refusal({"stats", "looks", "--trials", "1000000,2000000"}),
              HasSubstr("accepted: up to 100000"));
  EXPECT_THAT(refusal({"stats", "randomisation",
                       file("orders.csv",
                            "trials,correct_first,answers_first,correct\n"
                            "1000000000,500000000,500000000,500000000\n")}),
              HasSubstr("1000000000 trials in all; accepted: up to 10000"));
  const std::string blocks =
      file("blocks.csv", "level,correct,trials\n1,10,20\n2,15,20\n3,900000000,1000000000\n");
  EXPECT_THAT(refusal({"stats", "psychometric", blocks}),
              HasSubstr("1000000040 trials in all; accepted: up to 1000000, or replicates 0"));
  EXPECT_THAT(refusal({"stats", "beta-binomial", file("many.csv", "correct,trials\n250000,400000\n5,10\n")}),
              HasSubstr("400010 trials in the rows that differ from each other; accepted: up to 50000"));
}

TEST_F(Stats, TakesSeedsAndPValuesBeyondOtherNumbers) {
  const std::string blocks = file("blocks.csv", "level,correct,trials\n1,10,20\n2,15,20\n3,18,20\n4,20,20\n");
  const auto seeded = [&](const std::string& seed) {
    return run({"stats", "psychometric", blocks, "--replicates", "199", "--seed", seed}).exit_code;
  };
  EXPECT_EQ(seeded("20240229120000"), 0);
  EXPECT_EQ(seeded("-1"), 1);
  EXPECT_EQ(seeded("99999999999999999999"), 1);
  EXPECT_EQ(run({"stats", "adjust", "--p", "1e-200,0.01"}).exit_code, 0);
}

TEST_F(Stats, SaysWhatAFileOfAnotherProgramLacks) {
  const Outcome latin = run({"stats", "bradley-terry", file("latin.csv", "winner,loser\na,b\ncaf\xE9,b\n")});
  EXPECT_EQ(latin.exit_code, 1);
  EXPECT_THAT(latin.err, HasSubstr("latin.csv:3: a byte that is no UTF-8; text is accepted in UTF-8"));
  for (const char* separator : {";", "\t"}) {
    const std::string text = "difference" + std::string(separator) + "x\n1" + separator + "2\n";
    const Outcome column = run({"stats", "sign", file("other.csv", text)});
    EXPECT_EQ(column.exit_code, 1);
    EXPECT_THAT(column.err, HasSubstr("x; columns are separated by commas"));
    const Outcome matrix = run({"stats", "friedman", file("other.csv", text)});
    EXPECT_THAT(matrix.err, HasSubstr("; columns are separated by commas"));
  }
}

// Parts computed apart, on several machines say, are joined to the very bits of one run.
TEST_F(Stats, PartsOfABootstrapMergeToOneRun) {
  const std::string data =
      file("answers.csv", "level,correct,trials\n1,12,20\n2,13,20\n3,17,20\n4,18,20\n5,20,20\n6,20,20\n");
  const std::vector<std::string> asked = {"stats",       "psychometric", data,           "--guess", "0.5",
                                          "--intervals", "bootstrap",    "--replicates", "200",     "--seed",
                                          "3",           "--format",     "json"};
  const auto with_shard = [&](const std::string& shard) {
    std::vector<std::string> arguments = asked;
    arguments.insert(arguments.end(), {"--shard", shard});
    return run(arguments).out;
  };
  const std::string first = file("1.json", with_shard("1/2")), second = file("2.json", with_shard("2/2"));
  const Outcome whole = run(asked), merged = run({"stats", "merge", second, first, "--format", "json"});
  ASSERT_EQ(merged.exit_code, 0) << merged.err;
  EXPECT_EQ(merged.out, whole.out);
  const Outcome lacking = run({"stats", "merge", first});
  EXPECT_EQ(lacking.exit_code, 1);
}

TEST_F(Stats, PartsOfAPowerSimulationMergeToOneRun) {
  std::string small = text_of(palpate::test::source_folder() + "/protocols/kuroda2003.toml");
  const auto put = [&small](const std::string& from, const std::string& to) {
    small.replace(small.find(from), from.size(), to);
  };
  put("../data", palpate::test::source_folder() + "/data");
  put("planned_examinees = 15", "planned_examinees = 2");
  put("per_cell = 4", "per_cell = 1");
  const std::string protocol = file("small.toml", small);
  const auto simulated = [&](const std::string& shard) {
    return run({"plan", protocol, "--studies", "2", "--seed", "5", "--shard", shard, "--format", "json"}).out;
  };
  const std::string first = file("1.json", simulated("1/2")), second = file("2.json", simulated("2/2"));
  const Outcome merged = run({"stats", "merge", second, first, "--format", "json"});
  ASSERT_EQ(merged.exit_code, 0) << merged.err;
  EXPECT_EQ(merged.out, simulated("1/1"));
  const Outcome twice = run({"stats", "merge", first, first});
  EXPECT_EQ(twice.exit_code, 1);
  EXPECT_THAT(twice.err, HasSubstr("study 1 is in two parts"));
}

TEST_F(Stats, ADamagedPartIsNamed) {
  const auto refusal = [this](const std::string& text) {
    const Outcome outcome = run({"stats", "merge", file("part.json", text)});
    EXPECT_EQ(outcome.exit_code, 1) << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr("part.json: "));
    EXPECT_THAT(outcome.err, HasSubstr("accepted: what --shard K/N --format json printed"));
    return outcome.err;
  };
  refusal(R"({"kind": 5})");
  refusal(R"({"procedure": 5})");
  refusal(R"({"procedure": "psychometric", "bootstrap": {"values": {}}})");
  refusal(R"({"kind": "power simulation", "from": 0})");
  const auto power = [](const std::string& studies, const std::string& cells) {
    return R"({"kind": "power simulation", "protocol": "p", "protocol_sha256": "s", "observer": {}, "seed": 1,)"
           R"( "studies": )" +
           studies + R"(, "from": 0, "to": 2, "cells": )" + cells + "}";
  };
  const std::string cell = R"([{"cell": "c", "rejected": 1}])";
  EXPECT_THAT(refusal(power("1", cell)), HasSubstr("studies 1 to 2 of 1 contradict each other"));
  EXPECT_THAT(refusal(power("2", "[]")), HasSubstr("no cells"));
  EXPECT_THAT(refusal(power("2", R"([{"cell": "c", "rejected": 3}])")), HasSubstr("3 of 2 studies reject"));
  EXPECT_EQ(run({"stats", "merge", file("part.json", power("2", cell))}).exit_code, 0);
}

TEST_F(Stats, PartsOfTwoProtocolsAreNotJoined) {
  const auto part = [this](const std::string& name, const std::string& protocol, int from) {
    const json text = {{"kind", "power simulation"},
                       {"protocol", protocol},
                       {"protocol_sha256", "s"},
                       {"observer", json::object()},
                       {"seed", 1},
                       {"studies", 2},
                       {"from", from},
                       {"to", from + 1},
                       {"cells", {{{"cell", "c"}, {"rejected", 1}}}}};
    return file(name, text.dump());
  };
  const std::string first = part("1.json", "one", 0);
  EXPECT_EQ(run({"stats", "merge", first, part("2.json", "one", 1)}).exit_code, 0);
  const Outcome other = run({"stats", "merge", first, part("2.json", "other", 1)});
  EXPECT_EQ(other.exit_code, 1);
  EXPECT_THAT(other.err, HasSubstr("different simulations"));
}

// Made by `palpate stats list --format markdown > docs/statistics.md`.
TEST_F(Stats, ThePageThatDocumentsThemIsUpToDate) {
  EXPECT_EQ(run({"stats", "list", "--format", "markdown"}).out,
            text_of(palpate::test::source_folder() + "/docs/statistics.md"));
}

}  // namespace palpate::test
