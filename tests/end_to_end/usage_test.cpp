// What `palpate` says to a slip of the keyboard, an empty shell variable and a folder that is not there.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "tests/end_to_end/program.hpp"
#include "tests/support/places.hpp"

namespace palpate::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

std::string source(const std::string& file) {
  return std::filesystem::path(source_folder()) / file;
}

class Usage : public testing::Test {
 protected:
  Usage() { std::filesystem::create_directories(folder_); }
  ~Usage() override { std::filesystem::remove_all(folder_); }

  std::string in_folder(const std::string& name) const { return folder_ / name; }

  const std::string protocol_ = source("protocols/kuroda2003.toml"),
                    scene_ = source("data/scenes/rectal-palpation.toml");

 private:
  std::filesystem::path folder_ =
      std::filesystem::temp_directory_path() / ("palpate-usage-" + std::to_string(::getpid()));
};

}  // namespace

TEST_F(Usage, ASlipOfTheKeyboardIsToldWithWhatWasMeant) {
  const auto said = [](const std::vector<std::string>& arguments) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_THAT(outcome.out, IsEmpty());
    return outcome.err;
  };
  EXPECT_THAT(said({"pres", scene_}), HasSubstr("no command 'pres'; did you mean press?"));
  EXPECT_THAT(said({"zzzzzz"}),
              AllOf(HasSubstr("no command 'zzzzzz'; accepted: check, "), HasSubstr("verify")));
  EXPECT_THAT(said({"press", scene_, "--modl", "none"}),
              HasSubstr("no option '--modl'; did you mean --model?"));
  EXPECT_THAT(said({"press", scene_, "--modl=none"}), HasSubstr("no option '--modl'; did you mean --model?"));
  EXPECT_THAT(said({"stats", "binomal"}), HasSubstr("no command 'binomal'; did you mean binomial?"));
  EXPECT_THAT(said({"stats", "binomial", "--corect", "4", "--trials", "9"}),
              HasSubstr("no option '--corect'; did you mean --correct?"));
  EXPECT_THAT(said({"verify", "a.db", "b.db"}),
              HasSubstr("found 'b.db', and no more arguments are expected"));
}

// The library would take --no-browser for the examinee.
TEST_F(Usage, AnEmptyValueIsRefused) {
  const std::string study = in_folder("s.db");
  for (const std::vector<std::string>& arguments :
       {std::vector<std::string>{"run", protocol_, "--study", study, "--examinee=", "--no-browser"},
        std::vector<std::string>{"run", protocol_, "--study", study, "--examinee", "", "--no-browser"}}) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_THAT(outcome.err, HasSubstr("--examinee: is empty; accepted: a value"));
    EXPECT_FALSE(std::filesystem::exists(study));
  }
  EXPECT_EQ(run({"simulate", protocol_, "--study=", "--examinees", "1"}).exit_code, 2);
  EXPECT_EQ(run({"verify", ""}).exit_code, 2);
}

TEST_F(Usage, AFolderThatIsNotThereIsTheInputsFault) {
  const std::string nowhere = in_folder("nowhere/");
  const auto said = [](const std::vector<std::string>& arguments) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.exit_code, 1) << outcome.err;
    return outcome.err;
  };
  const std::string why = "nowhere is not there; accepted: a file in a folder that is there";
  EXPECT_THAT(said({"render", scene_, "--out", nowhere + "a.png"}), HasSubstr(why));
  EXPECT_THAT(said({"press", scene_, "--plot", nowhere + "a.svg"}), HasSubstr(why));
  EXPECT_THAT(said({"press", scene_, "--save", nowhere + "a"}), HasSubstr(why));
  EXPECT_THAT(said({"mesh", source("data/meshes/rectum.msh"), "--unit", "m", "--out", nowhere + "a.vtu"}),
              HasSubstr(why));
  EXPECT_THAT(said({"cost", scene_, "--plot", nowhere + "a.svg"}), HasSubstr(why));
  EXPECT_THAT(said({"simulate", protocol_, "--study", nowhere + "s.db", "--examinees", "1"}),
              HasSubstr("does not exist"));
  const std::string study = in_folder("s.db"), file = in_folder("file");
  std::ofstream(file) << "text";
  ASSERT_EQ(run({"simulate", protocol_, "--study", study, "--examinees", "1", "--seed", "1"}).exit_code, 0);
  EXPECT_THAT(said({"report", study, "--run-mode", "simulated", "--out", nowhere + "a.html"}),
              HasSubstr(why));
  EXPECT_THAT(said({"merge", nowhere + "m.db", study, study}), HasSubstr("nowhere"));
  EXPECT_THAT(said({"export", study, "--as", "csv", "--out", file + "/out"}), HasSubstr("is no folder"));
  EXPECT_THAT(said({"demo", "--out", file + "/out"}), HasSubstr("a part of it is a file"));
}

TEST_F(Usage, AConditionAndACellOfAProtocolAreChosen) {
  const Outcome all = run({"press", protocol_, "--steps", "1"});
  EXPECT_THAT(all.out, AllOf(HasSubstr("soft"), HasSubstr("hard"), HasSubstr("sibille")));
  const Outcome one = run({"press", protocol_, "--steps", "1", "--condition", "hard", "--cell", "kuroda"});
  EXPECT_EQ(one.exit_code, 0) << one.err;
  EXPECT_THAT(one.out, AllOf(HasSubstr("hard"), Not(HasSubstr("soft")), Not(HasSubstr("sibille"))));
  const Outcome unknown = run({"press", protocol_, "--condition", "herd"});
  EXPECT_EQ(unknown.exit_code, 1);
  EXPECT_THAT(unknown.err, HasSubstr("has no such condition; accepted: soft, hard, absent"));
  const Outcome several = run({"render", protocol_, "--out", in_folder("a.png")});
  EXPECT_EQ(several.exit_code, 1);
  EXPECT_THAT(several.err,
              HasSubstr("accepted: --condition soft or hard or absent and --cell kuroda or sibille"));
  EXPECT_THAT(run({"press", scene_, "--cell", "kuroda"}).err,
              HasSubstr("choose from a protocol, and this is a scene"));
  const Outcome cost = run({"cost", protocol_});
  EXPECT_EQ(cost.exit_code, 1);
  EXPECT_THAT(cost.err,
              AllOf(HasSubstr("is a protocol, and a scene is needed"), HasSubstr("rectal-palpation.toml")));
}

}  // namespace palpate::test
