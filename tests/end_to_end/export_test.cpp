// `palpate export` as a lab uses it: nothing half-written, nothing overwritten, and other tools find in it
// what the report found in the study file.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/end_to_end/program.hpp"
#include "tests/support/places.hpp"
#include "tests/trials/support/files.hpp"

namespace palpate {
namespace {

using nlohmann::json;
using test::Outcome;
using test::run;
using testing::HasSubstr;
using testing::IsEmpty;
using trials::test::read;
using trials::test::TemporaryFolder;
using trials::test::write;

bool succeeds(const std::string& command) {
  return std::system((command + " > /dev/null 2>&1").c_str()) == 0;
}

class Export : public testing::Test {
 protected:
  Export() {
    const std::string protocol = palpate::test::source_folder() + "/protocols/kuroda2003.toml";
    const Outcome made =
        run({"simulate", protocol, "--study", file("a.db"), "--examinees", "6", "--seed", "1"});
    EXPECT_EQ(made.exit_code, 0) << made.err;
  }
  std::string file(const std::string& name) const { return (folder_ / name).string(); }
  Outcome exported(const std::string& as, const std::string& out) const {
    return run({"export", file("a.db"), "--as", as, "--out", file(out), "--author", "A. Author"});
  }
  std::vector<std::string> names() const {
    std::vector<std::string> found;
    for (const auto& entry : std::filesystem::directory_iterator(folder_.path()))
      found.push_back(entry.path().filename());
    std::ranges::sort(found);
    return found;
  }

  /// What other tools counted goes through `palpate stats`, and must give what the report gives.
  void expect_the_report_s_numbers(const std::string& counted) const {
    const json report = json::parse(
        run({"report", file("a.db"), "--run-mode", "simulated", "--interim", "--format", "json"}).out);
    std::istringstream cells(read(folder_ / counted / "cells.csv"));
    std::string line;
    std::getline(cells, line);
    ASSERT_EQ(line, "cell,correct,trials");
    std::size_t found = 0;
    for (const json& cell : report.at("cells")) {
      ASSERT_TRUE(std::getline(cells, line));  // both in alphabetical order
      const std::size_t first = line.find(','), second = line.rfind(',');
      EXPECT_EQ(line.substr(0, first), cell.at("cell"));
      const Outcome stats =
          run({"stats", "binomial", "--correct", line.substr(first + 1, second - first - 1), "--trials",
               line.substr(second + 1), "--side", "greater", "--format", "json"});
      ASSERT_EQ(stats.exit_code, 0) << stats.err;
      const json result = json::parse(stats.out);
      for (const char* number :
           {"correct", "trials", "proportion", "p", "p_values", "interval", "bound", "wilson"})
        EXPECT_EQ(result.at(number), cell.at("primary").at(number)) << number;
      ++found;
    }
    EXPECT_EQ(found, 2U);
    const Outcome stats = run({"stats", "permutation", file(counted + "/differences.csv"), "--side",
                               "two-sided", "--format", "json"});
    ASSERT_EQ(stats.exit_code, 0) << stats.err;
    const json computed = json::parse(stats.out), told = report.at("comparisons").at(0).at("sign_flip");
    EXPECT_EQ(computed.at("n"), told.at("n"));
    EXPECT_DOUBLE_EQ(computed.at("mean").get<double>(), told.at("mean").get<double>());
    EXPECT_EQ(computed.at("p_values"), told.at("p_values"));
    EXPECT_GT(told.at("mean").get<double>(), 0.0);
  }

  TemporaryFolder folder_;
};

TEST_F(Export, EveryFormatAppears) {
  for (const char* as : {"csv", "json", "psych-ds", "bids"}) {
    const Outcome outcome = exported(as, as);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_THAT(outcome.err, IsEmpty());
    EXPECT_THAT(outcome.out, HasSubstr(file(as)));
  }
  EXPECT_EQ(names(), (std::vector<std::string>{"a.db", "a.db.head", "bids", "csv", "json", "psych-ds"}));
  EXPECT_THAT(read(folder_ / "bids/README.md"), HasSubstr("6 simulated"));
}

TEST_F(Export, SaysThatAuthorsAreMissing) {
  const Outcome outcome = run({"export", file("a.db"), "--as", "bids", "--out", file("bids")});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_THAT(outcome.err, HasSubstr("--author"));
}

TEST_F(Export, OverwritesNothing) {
  for (const char* as : {"csv", "json", "psych-ds", "bids"}) {
    ASSERT_EQ(exported(as, "out").exit_code, 0);
    const Outcome again = exported(as, "out");
    EXPECT_EQ(again.exit_code, 1);
    EXPECT_THAT(again.err, HasSubstr("is there already and is not overwritten"));
    std::filesystem::remove_all(folder_ / "out");
    std::filesystem::create_directory(folder_ / "out");
    write(folder_ / "out/dataset_description.json", "mine");
    write(folder_ / "out/trials.csv", "mine");
    write(folder_ / "out/study.json", "mine");
    EXPECT_EQ(exported(as, "out").exit_code, 1) << as;
    for (const char* name : {"dataset_description.json", "trials.csv", "study.json"})
      EXPECT_EQ(read(folder_ / "out" / name), "mine");
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder_ / "out"), {}), 3);
    std::filesystem::remove_all(folder_ / "out");
  }
  EXPECT_EQ(names(), (std::vector<std::string>{"a.db", "a.db.head"}));
}

TEST_F(Export, AFullDiskLeavesNothing) {
  for (const char* as : {"csv", "json", "psych-ds", "bids"}) {
    // Files may not grow beyond 4 blocks of 1024 bytes.
    const std::string command = "ulimit -f 4; exec " + palpate::test::program_file() + " export " +
                                file("a.db") + " --as " + as + " --out " + file("x/out") + " 2> " +
                                file("said");
    const int status = std::system(("bash -c \"" + command + "\" > /dev/null").c_str());
    EXPECT_EQ(WEXITSTATUS(status), 3) << as;
    EXPECT_THAT(read(folder_ / "said"), HasSubstr("cannot write: File too large")) << as;
    EXPECT_EQ(names(), (std::vector<std::string>{"a.db", "a.db.head", "said"})) << as;
  }
}

TEST_F(Export, AFolderThatCannotBeWrittenIsSaid) {
  for (const char* as : {"csv", "bids"}) {
    const Outcome outcome = run({"export", file("a.db"), "--as", as, "--out", "/proc/palpate/out"});
    EXPECT_EQ(outcome.exit_code, 3);
    EXPECT_THAT(outcome.err, HasSubstr("/proc/palpate: cannot make a folder there"));
  }
}

TEST_F(Export, RReadsItAndGetsTheReportsNumbers) {
  ASSERT_TRUE(succeeds("command -v Rscript")) << "install r-base-core, as packages.txt says";
  ASSERT_EQ(exported("csv", "csv").exit_code, 0);
  std::filesystem::create_directory(folder_ / "r");
  const std::string script = palpate::test::source_folder() + "/tests/end_to_end/read_export.R";
  ASSERT_TRUE(succeeds("Rscript --vanilla " + script + " " + file("csv") + " " + file("r")));
  expect_the_report_s_numbers("r");
}

TEST_F(Export, PandasReadsItAndGetsTheReportsNumbers) {
  const std::string python = "/usr/bin/python3";  // Debian's own, which has python3-pandas
  ASSERT_TRUE(succeeds(python + " -c 'import pandas'")) << "install python3-pandas, as packages.txt says";
  const std::string script =
      python + " " + palpate::test::source_folder() + "/tests/end_to_end/read_export.py ";
  for (const auto& [as, option] : {std::pair{"csv", ""}, std::pair{"bids", " --bids"}}) {
    ASSERT_EQ(exported(as, as).exit_code, 0);
    const std::string out = std::string("from-") + as;
    std::filesystem::create_directory(folder_ / out);
    ASSERT_TRUE(succeeds(script + file(as) + " " + file(out) + option)) << as;
    expect_the_report_s_numbers(out);
  }
}

}  // namespace
}  // namespace palpate
