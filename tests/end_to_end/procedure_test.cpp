// `palpate procedure` as a user runs it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/end_to_end/program.hpp"

namespace palpate::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

class ProcedureCommand : public testing::Test {
 protected:
  ProcedureCommand() { std::filesystem::create_directories(folder_); }
  ~ProcedureCommand() override { std::filesystem::remove_all(folder_); }

  /// A file with a [procedure] table of these keys.
  std::string file(const std::string& keys) const {
    const std::string name = folder_ / "procedure.toml";
    std::ofstream(name) << "[procedure]\n" << keys;
    return name;
  }
  std::string in_folder(const std::string& name) const { return folder_ / name; }

 private:
  std::filesystem::path folder_ =
      std::filesystem::temp_directory_path() / ("palpate-procedure-" + std::to_string(::getpid()));
};

const std::string kStaircaseFile =
    "kind = \"staircase\"\nlevel = \"bodies.prostate.young_modulus\"\nstart = \"5 MPa\"\n"
    "steps = [\"1 MPa\", \"0.5 MPa\"]\nstop = { reversals = 3 }\n";
const std::string kQuestPlusFile =
    "kind = \"questplus\"\nfunction = \"logistic\"\nlevels = [0, 1, 2]\n"
    "parameters = { threshold = [0, 1, 2], slope = [1, 3], guess = 0.5, lapse = 0.02 }\n";

}  // namespace

TEST_F(ProcedureCommand, PrintsEachLevelAndWhereItStopped) {
  const Outcome outcome = run({"procedure", file(kStaircaseFile), "--answers", "1,1,0,1,1,0"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, StartsWith("staircase of bodies.prostate.young_modulus: "));
  EXPECT_THAT(outcome.out,
              AllOf(HasSubstr("reversals: trial 3 at 3 MPa, trial 5 at 3.5 MPa, trial 6 at 3 MPa"),
                    HasSubstr("mean of reversals 3.16667 MPa"), HasSubstr("stopped at trial 6")));
}

TEST_F(ProcedureCommand, AsJsonAStaircaseHasItsReversals) {
  const auto json = nlohmann::json::parse(
      run({"procedure", file(kStaircaseFile), "--answers", "1,1,0,1", "--format", "json"}).out);
  EXPECT_EQ(json["unit"], "MPa");
  EXPECT_EQ(json["trials"][2], (nlohmann::json{{"trial", 3}, {"level", 3.0}, {"answer", 0}}));
  EXPECT_EQ(json["reversals"], (nlohmann::json{{{"trial", 3}, {"level", 3.0}}}));
  EXPECT_EQ(json["next_level"], 3.5);
  EXPECT_EQ(json["mean_of_reversals"], 3.0);
  EXPECT_TRUE(json["stopped_at"].is_null());
}

TEST_F(ProcedureCommand, AsJsonABayesianProcedureHasItsBelief) {
  const auto json = nlohmann::json::parse(
      run({"procedure", file(kQuestPlusFile), "--answers", "1,0", "--format", "json"}).out);
  EXPECT_TRUE(json["unit"].is_null());
  for (const auto& trial : json["trials"]) {
    for (const char* figure : {"mean", "mode", "sd"})
      for (const char* parameter : {"threshold", "slope", "guess", "lapse"})
        EXPECT_TRUE(trial[figure][parameter].is_number()) << figure << parameter;
    EXPECT_GT(trial["entropy"], 0.0);
    EXPECT_GT(trial["expected_entropy"], 0.0);
  }
  EXPECT_EQ(json["reversals"], nlohmann::json::array());
}

TEST_F(ProcedureCommand, AsCsvEachTrialIsARow) {
  EXPECT_EQ(run({"procedure", file(kStaircaseFile), "--answers", "1,1,0", "--format", "csv"}).out,
            "trial,level,unit,answer\n1,5,MPa,1\n2,4,MPa,1\n3,3,MPa,0\n");
  EXPECT_THAT(run({"procedure", file(kQuestPlusFile), "--answers", "1", "--format", "csv"}).out,
              StartsWith("trial,level,answer,threshold_mean,threshold_mode,threshold_sd,slope_mean,"));
}

TEST_F(ProcedureCommand, WithoutAnswersTellsTheFirstLevel) {
  EXPECT_THAT(run({"procedure", file(kStaircaseFile)}).out, HasSubstr("next level 5 MPa"));
}

TEST_F(ProcedureCommand, DrawsTheLevels) {
  const std::string plot = in_folder("levels.svg");
  for (const std::string& keys : {kStaircaseFile, kQuestPlusFile}) {
    std::filesystem::remove(plot);
    const Outcome outcome = run({"procedure", file(keys), "--answers", "1,1,0,1", "--plot", plot});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_GT(std::filesystem::file_size(plot), 1000U);
  }
}

TEST_F(ProcedureCommand, BadInputIsToldWithWhatIsAccepted) {
  const auto said = [](const std::vector<std::string>& arguments) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.exit_code, 1);
    EXPECT_EQ(outcome.out, "");
    return outcome.err;
  };
  const std::string staircase = file(kStaircaseFile);
  EXPECT_THAT(said({"procedure", staircase, "--answers", "1,2"}),
              HasSubstr("--answers: answer 2 is \"2\"; accepted: 1 (correct) and 0 (wrong)"));
  EXPECT_THAT(said({"procedure", staircase, "--answers", "1,"}), HasSubstr("answer 2 is \"\""));
  EXPECT_THAT(said({"procedure", staircase, "--answers", "1,1,0,1,1,0,1,1"}),
              HasSubstr("found 8 answers, and the run ends after trial 6; accepted: at most 6"));
  EXPECT_THAT(
      said({"procedure", file("kind = \"constant\"")}),
      HasSubstr(
          "procedure.kind: found \"constant\", accepted: staircase, weighted, questplus, quest, psi, pest"));
  EXPECT_THAT(said({"procedure", in_folder("nowhere.toml")}), HasSubstr("nowhere.toml"));
  EXPECT_THAT(said({"procedure", file(kStaircaseFile), "--plot", in_folder("a.svg")}),
              HasSubstr("--plot: no trials to draw"));
}

}  // namespace palpate::test
