// The life of a study file, as a user of the program sees it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <sstream>
#include <thread>

#include "tests/end_to_end/program.hpp"
#include "tests/support/places.hpp"
#include "tests/trials/support/files.hpp"
#include "tests/trials/support/raw_sql.hpp"

namespace palpate {
namespace {

using nlohmann::json;
using test::Outcome;
using test::run;
using testing::HasSubstr;
using testing::StartsWith;
using trials::test::read;
using trials::test::TemporaryFolder;
using trials::test::write;

const std::string kProtocol = palpate::test::source_folder() + "/protocols/kuroda2003.toml";

class StudyEndToEnd : public testing::Test {
 protected:
  std::string file(const std::string& name) const { return (folder_ / name).string(); }
  std::vector<std::string> simulate(const std::string& study, int examinees,
                                    const std::string& seed = "1") const {
    return {"simulate", kProtocol, "--study", file(study), "--examinees", std::to_string(examinees),
            "--seed",   seed};
  }
  /// The exported answers without what differs from run to run: onset_utc, the 13th column.
  std::string answers(const std::string& study) const {
    const TemporaryFolder out;
    const Outcome exported = run({"export", file(study), "--as", "csv", "--out", out.path().string()});
    EXPECT_EQ(exported.exit_code, 0) << exported.err;
    std::istringstream lines(read(out / "trials.csv"));
    std::string kept;
    for (std::string line; std::getline(lines, line);) {
      std::istringstream cells(line);
      std::string cell;
      for (int column = 1; std::getline(cells, cell, ','); ++column)
        if (column != 13) kept += cell + ',';
      kept += '\n';
    }
    return kept;
  }
  int stored_answers(const std::string& study) const {
    const std::string count = trials::test::sql_value(folder_ / study, "SELECT count(*) FROM answer");
    return count.empty() ? 0 : std::stoi(count);
  }
  /// Waits until so many answers are on the disk, or the program is over.
  void wait_for_answers(const std::string& study, int answers, test::Running& program) const {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(120);
    while (std::chrono::steady_clock::now() < end && !program.is_over()) {
      if (std::filesystem::exists(folder_ / study) && stored_answers(study) >= answers) return;
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
  }

  TemporaryFolder folder_;
};

TEST_F(StudyEndToEnd, OneSeedGivesTheSameAnswersTwice) {
  ASSERT_EQ(run(simulate("a.db", 2)).exit_code, 0);
  ASSERT_EQ(run(simulate("b.db", 2)).exit_code, 0);
  ASSERT_EQ(run(simulate("c.db", 2, "2")).exit_code, 0);
  EXPECT_EQ(answers("a.db"), answers("b.db"));
  EXPECT_NE(answers("a.db"), answers("c.db"));
}

// CLI11 alone stores 2^64 - 1 for either, without a word.
TEST_F(StudyEndToEnd, ASeedThatIsNoneIsRefused) {
  for (const char* seed : {"-1", "99999999999999999999", "0x10", "one"}) {
    std::vector<std::vector<std::string>> commands = {
        simulate("a.db", 1, seed),
        {"demo", "--out", file("demo"), "--examinees", "1", "--seed", seed},
        {"plan", kProtocol, "--studies", "1", "--seed", seed}};
    for (const std::vector<std::string>& command : commands) {
      const Outcome outcome = run(command);
      EXPECT_EQ(outcome.exit_code, 2) << command.front() << ' ' << outcome.out;
      EXPECT_THAT(outcome.err,
                  HasSubstr("--seed: found " + std::string(seed) + ", accepted: a whole number"));
    }
  }
  EXPECT_FALSE(std::filesystem::exists(folder_ / "a.db"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "demo"));
}

// A file may be called anything; JSON is UTF-8.
TEST_F(StudyEndToEnd, JsonIsWholeWhateverTheFileIsCalled) {
  std::vector<std::string> command = simulate("caf\xE9.db", 1);
  command.insert(command.end(), {"--format", "json"});
  const Outcome simulated = run(command);
  EXPECT_EQ(simulated.exit_code, 0) << simulated.err;
  EXPECT_EQ(json::parse(simulated.out).at("study"), file("caf\xEF\xBF\xBD.db"));
  const Outcome verified = run({"verify", file("caf\xE9.db"), "--format", "json"});
  EXPECT_EQ(verified.exit_code, 0) << verified.err;
  EXPECT_EQ(json::parse(verified.out).at("study"), file("caf\xEF\xBF\xBD.db"));
}

TEST_F(StudyEndToEnd, APlanTooLargeToComputeIsRefused) {
  std::string large = read(kProtocol);
  const std::string planned = "planned_examinees = 15";
  large.replace(large.find(planned), planned.size(), "planned_examinees = 100000");
  large.replace(large.find("../data"), 7, palpate::test::source_folder() + "/data");
  write(file("large.toml"), large);
  const Outcome outcome = run({"plan", file("large.toml")});
  EXPECT_EQ(outcome.exit_code, 1) << outcome.out;
  EXPECT_THAT(outcome.err, HasSubstr("400000 trials in a cell (100000 examinees with 4 each)"));
}

TEST_F(StudyEndToEnd, ResultsGoToStdoutAndAPipeShowsNoBar) {
  const Outcome outcome = run(simulate("a.db", 1));
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.err, "");
  EXPECT_THAT(outcome.out, HasSubstr("1 simulated examinee added"));
  EXPECT_THAT(outcome.out, HasSubstr("receipt 10-"));  // the session's beginning, eight answers and its end
}

TEST_F(StudyEndToEnd, AKilledSimulationGoesOnWhereItWas) {
  {
    test::Running program(simulate("a.db", 12));
    wait_for_answers("a.db", 20, program);
    program.send(SIGKILL);
    ASSERT_EQ(program.wait(), 128 + SIGKILL) << "it was over before it could be killed";
  }
  const int before = stored_answers("a.db");
  EXPECT_GE(before, 20);
  const Outcome rest = run(simulate("a.db", 12));  // only a study that is whole goes on
  EXPECT_EQ(rest.exit_code, 0) << rest.err;
  EXPECT_EQ(stored_answers("a.db"), 96);
  EXPECT_THAT(rest.out, HasSubstr(std::to_string(96 - before) + " answers given"));
  EXPECT_EQ(run({"verify", file("a.db")}).exit_code, 0);
}

// The last answer that was seen may not have been called saved yet.
TEST_F(StudyEndToEnd, AKilledSimulationsLogMayBeDamagedOrLost) {
  test::Running program(simulate("a.db", 12));
  wait_for_answers("a.db", 20, program);
  program.send(SIGKILL);
  ASSERT_EQ(program.wait(), 128 + SIGKILL) << "it was over before it could be killed";
  std::string log = read(folder_ / "a.db-wal");
  for (std::size_t at = 0; at < log.size(); at += 100) log[at] = static_cast<char>(log[at] ^ 1);
  write(folder_ / "a.db-wal", log);
  const Outcome verified = run({"verify", file("a.db"), "--format", "json"});
  EXPECT_EQ(verified.exit_code, 0) << verified.out;
  EXPECT_GE(json::parse(verified.out).at("answers"), 19);
  EXPECT_EQ(run(simulate("a.db", 12)).exit_code, 0);
}

TEST_F(StudyEndToEnd, ASecondProgramWaitsForTheFirst) {
  test::Running program(simulate("a.db", 12));
  wait_for_answers("a.db", 5, program);
  const Outcome second = run(simulate("a.db", 12));
  program.send(SIGINT);
  ASSERT_EQ(program.wait(), 130);
  EXPECT_EQ(second.exit_code, 3);
  EXPECT_THAT(second.err, HasSubstr("another palpate is leading a session in this study (pid "));
  EXPECT_EQ(run({"verify", file("a.db")}).exit_code, 0);
}

TEST_F(StudyEndToEnd, CtrlCStopsWithEverythingOnTheDisk) {
  test::Running program(simulate("a.db", 12));
  wait_for_answers("a.db", 5, program);
  program.send(SIGINT);
  ASSERT_EQ(program.wait(), 130);
  EXPECT_FALSE(std::filesystem::exists(file("a.db-wal")));  // closed in good order
  EXPECT_EQ(run({"verify", file("a.db")}).exit_code, 0);
}

TEST_F(StudyEndToEnd, VerifyHoldsAReceiptAgainstTheFile) {
  const Outcome made = run(simulate("a.db", 1));
  const std::string receipt = made.out.substr(made.out.find("receipt ") + 8, 3 + 64);
  const Outcome whole = run({"verify", file("a.db"), "--receipt", receipt, "--format", "json"});
  EXPECT_EQ(whole.exit_code, 0) << whole.err;
  EXPECT_TRUE(json::parse(whole.out).at("whole").get<bool>());
  const Outcome other = run({"verify", file("a.db"), "--receipt", "10-" + std::string(64, 'a')});
  EXPECT_EQ(other.exit_code, 1);
  EXPECT_THAT(other.out, HasSubstr("entry 10 is not the one"));
  EXPECT_EQ(run({"verify", file("a.db"), "--receipt", "nonsense"}).exit_code, 1);
}

TEST_F(StudyEndToEnd, ATamperedFileIsFound) {
  ASSERT_EQ(run(simulate("a.db", 1)).exit_code, 0);
  ASSERT_EQ(
      trials::test::sql(folder_ / "a.db",
                        "DROP TRIGGER answer_refuses_UPDATE; UPDATE answer SET response = 3 - response"),
      "");
  const Outcome outcome = run({"verify", file("a.db")});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_THAT(outcome.out, HasSubstr("chain: entry 2 was altered"));
  EXPECT_THAT(outcome.err, HasSubstr("is not whole"));
}

TEST_F(StudyEndToEnd, FilesThatAreNoStudyAreRefusedAndLeftAlone) {
  ASSERT_EQ(run(simulate("whole.db", 1)).exit_code, 0);
  trials::test::sql(folder_ / "foreign.db", "CREATE TABLE t (x)");
  write(folder_ / "text.db", "my notes, which must not be lost\n");
  write(folder_ / "cut.db", read(folder_ / "whole.db").substr(0, 6000));
  for (const char* name : {"foreign.db", "text.db", "cut.db"}) {
    const std::string before = read(folder_ / name);
    for (const auto& arguments :
         {simulate(name, 1), std::vector<std::string>{"verify", file(name)},
          std::vector<std::string>{"export", file(name), "--as", "csv", "--out", file("x")}}) {
      const Outcome outcome = run(arguments);
      EXPECT_EQ(outcome.exit_code, 1) << arguments[0];
      EXPECT_THAT(outcome.err, StartsWith("Error: " + file(name) + ": "));
      EXPECT_EQ(std::ranges::count(outcome.err, '\n'), 1);
    }
    EXPECT_EQ(read(folder_ / name), before);
  }
  EXPECT_FALSE(std::filesystem::exists(file("x")));
}

TEST_F(StudyEndToEnd, ARefusedStartMakesNothing) {
  for (const auto& [protocol, examinees] : std::vector<std::pair<std::string, std::string>>{
           {file("none.toml"), "1"}, {kProtocol, "0"}, {kProtocol, "many"}}) {
    const Outcome outcome = run({"simulate", protocol, "--study", file("a.db"), "--examinees", examinees});
    EXPECT_EQ(outcome.exit_code, protocol == kProtocol ? 2 : 1) << outcome.err;
    EXPECT_TRUE(std::filesystem::is_empty(folder_.path()));
  }
}

TEST_F(StudyEndToEnd, AReportTakesNoStudysPlaceAndNeedsOneThatIsWhole) {
  ASSERT_EQ(run(simulate("a.db", 1)).exit_code, 0);
  const std::string before = read(folder_ / "a.db");
  for (const char* out : {"a.db", "notes.txt"}) {
    const Outcome refused = run({"report", file("a.db"), "--run-mode", "simulated", "--out", file(out)});
    EXPECT_EQ(refused.exit_code, 1);
    EXPECT_THAT(refused.err, HasSubstr("ends in .html"));
  }
  EXPECT_EQ(read(folder_ / "a.db"), before);
  ASSERT_EQ(trials::test::sql(folder_ / "a.db",
                              "DROP TRIGGER answer_refuses_UPDATE;UPDATE answer SET response = 3 - response, "
                              "correct = 1 - correct"),
            "");
  for (const std::vector<std::string>& asked :
       {std::vector<std::string>{"report", file("a.db"), "--run-mode", "simulated"},
        {"export", file("a.db"), "--as", "csv", "--out", file("out")},
        {"simulate", kProtocol, "--study", file("a.db"), "--examinees", "2", "--seed", "1"}}) {
    const Outcome refused = run(asked);
    EXPECT_EQ(refused.exit_code, 1) << refused.out;
    EXPECT_THAT(refused.err, HasSubstr("is not whole"));
    EXPECT_EQ(refused.out, "");
  }
}

TEST_F(StudyEndToEnd, ExportOverwritesNothing) {
  ASSERT_EQ(run(simulate("a.db", 1)).exit_code, 0);
  const std::vector<std::string> to_csv{"export", file("a.db"), "--as", "csv", "--out", file("out")};
  ASSERT_EQ(run(to_csv).exit_code, 0);
  write(folder_ / "out/trials.csv", "mine");
  const Outcome again = run(to_csv);
  EXPECT_EQ(again.exit_code, 1);
  EXPECT_THAT(again.err, HasSubstr("trials.csv: is there already"));
  EXPECT_EQ(read(folder_ / "out/trials.csv"), "mine");
  ASSERT_EQ(run({"export", file("a.db"), "--as", "json", "--out", file("out")}).exit_code, 0);
  const json exported = json::parse(read(folder_ / "out/study.json"));
  EXPECT_EQ(exported.at("trials").at("rows").size(), 8U);
  EXPECT_EQ(exported.at("intervals").at("rows").size(), 16U);
  EXPECT_EQ(exported.at("trials").at("rows").at(0).at("run_mode"), "simulated");
}

TEST_F(StudyEndToEnd, AFullDiskIsSaidAndLosesNothing) {
  ASSERT_EQ(run(simulate("a.db", 1)).exit_code, 0);
  // In the shell a block is 1024 bytes: nothing may grow beyond twice what is there, so the second examinee
  // does not fit.
  const auto blocks = std::filesystem::file_size(folder_ / "a.db") / 1024 + 8;
  const std::string command = "ulimit -f " + std::to_string(blocks) + "; exec " +
                              palpate::test::program_file() + " simulate " + kProtocol + " --study " +
                              file("a.db") + " --examinees 6 --seed 1 2> " + file("said");
  const int status = std::system(("bash -c \"" + command + "\" > /dev/null").c_str());
  EXPECT_EQ(WEXITSTATUS(status), 3);
  EXPECT_THAT(read(folder_ / "said"), HasSubstr("every answer given before is kept"));
  const Outcome verified = run({"verify", file("a.db")});
  EXPECT_EQ(verified.exit_code, 0) << verified.out;
  EXPECT_GE(stored_answers("a.db"), 8);
  EXPECT_EQ(run(simulate("a.db", 6)).exit_code, 0);
  EXPECT_EQ(stored_answers("a.db"), 48);
}

TEST_F(StudyEndToEnd, EveryCommandHasAnExample) {
  for (const char* command : {"simulate", "export", "merge", "verify"}) {
    const Outcome help = run({command, "--help"});
    EXPECT_EQ(help.exit_code, 0);
    EXPECT_THAT(help.out, HasSubstr(std::string("Example:\n  palpate ") + command));
  }
}

}  // namespace
}  // namespace palpate
