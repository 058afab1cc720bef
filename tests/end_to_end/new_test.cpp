// palpate new, as somebody uses it who has never seen a protocol.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>

#include "tests/end_to_end/program.hpp"
#include "tests/support/places.hpp"
#include "tests/support/temporary_folder.hpp"

namespace palpate::test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

std::string text_of(const fs::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

class New : public testing::Test {
 protected:
  std::string in_folder(const std::string& name) const { return folder_ / name; }

 private:
  TemporaryFolder folder_{};
};

TEST_F(New, WhatItMakesIsSoundAndRunsFromStartToReport) {
  const std::string study = in_folder("wall-stiffness"), protocol = study + "/protocol.toml",
                    file = study + "/simulated.db";
  const Outcome made = run({"new", study});
  ASSERT_EQ(made.exit_code, 0) << made.err;
  for (const char* name : {"protocol.toml", "scene.toml", "meshes/prostate.msh", "meshes/rectum.msh"})
    EXPECT_THAT(made.out, HasSubstr(study + "/" + name));
  EXPECT_THAT(text_of(protocol), HasSubstr("name = \"wall-stiffness\""));

  const Outcome checked = run({"check", protocol, "--format", "json"});
  ASSERT_EQ(checked.exit_code, 0) << checked.err;
  EXPECT_EQ(json::parse(checked.out)["warnings"], json::array());
  const Outcome scene = run({"check", study + "/scene.toml"});
  EXPECT_EQ(scene.exit_code, 0) << scene.err;
  EXPECT_THAT(scene.out, Not(HasSubstr("warning")));

  // The commands that it names next, as they stand.
  std::istringstream lines(made.out);
  int commands = 0;
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("  palpate ")) continue;
    std::istringstream words(line.substr(10));
    const std::vector<std::string> arguments{std::istream_iterator<std::string>(words), {}};
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.exit_code, 0) << line << "\n" << outcome.err;
    ++commands;
  }
  EXPECT_EQ(commands, 3);
  const Outcome report = run({"report", file, "--run-mode", "simulated"});
  EXPECT_EQ(report.exit_code, 0) << report.err;
  EXPECT_THAT(report.out, HasSubstr("15 of 15 planned simulated examinees completed the study"));
}

TEST_F(New, TheFolderStandsAlone) {
  const std::string study = in_folder("mine"), moved = in_folder("elsewhere");
  ASSERT_EQ(run({"new", study}).exit_code, 0);
  fs::rename(study, moved);
  EXPECT_EQ(run({"check", moved + "/protocol.toml"}).exit_code, 0);
}

TEST_F(New, NothingIsEverOverwritten) {
  const std::string study = in_folder("mine");
  ASSERT_EQ(run({"new", study}).exit_code, 0);
  std::ofstream(study + "/protocol.toml") << "my work";
  const Outcome again = run({"new", study});
  EXPECT_EQ(again.exit_code, 1);
  EXPECT_THAT(again.err, HasSubstr("mine: is there already and is not overwritten; accepted: another name"));
  EXPECT_EQ(text_of(study + "/protocol.toml"), "my work");
  for (const std::string& taken : {in_folder("file"), in_folder("empty"), in_folder("link")}) {
    if (taken.ends_with("file")) std::ofstream(taken) << "x";
    if (taken.ends_with("empty")) fs::create_directory(taken);
    if (taken.ends_with("link")) fs::create_symlink("nowhere", taken);
    EXPECT_EQ(run({"new", taken}).exit_code, 1) << taken;
  }
  EXPECT_EQ(text_of(in_folder("file")), "x");
}

TEST_F(New, NamesThatAProtocolCannotHaveAreRefused) {
  for (const char* name : {"my study", "Straße", "a.b", ".", ".."}) {
    const Outcome outcome = run({"new", in_folder(name)});
    EXPECT_EQ(outcome.exit_code, 1) << name;
    EXPECT_THAT(outcome.err, HasSubstr("accepted: ")) << name;
  }
  EXPECT_EQ(run({"new", in_folder("mine/")}).exit_code, 0);
  EXPECT_EQ(run({"new", in_folder("a/b/c")}).exit_code, 0);
  EXPECT_THAT(text_of(in_folder("a/b/c/protocol.toml")), HasSubstr("name = \"c\""));
}

TEST_F(New, WordsOfLaterVersionsAreToldAsSuch) {
  for (const auto& [option, word] : {std::pair{"--task", "ABX"}, {"--procedure", "staircase"}}) {
    const Outcome outcome = run({"new", in_folder("mine"), option, word});
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_THAT(outcome.err, AllOf(HasSubstr(word), HasSubstr("which is not in this version, accepted: ")));
  }
  EXPECT_EQ(run({"new", in_folder("mine"), "--task", "2IFC", "--procedure", "constant"}).exit_code, 0);
  EXPECT_EQ(run({"new"}).exit_code, 2);
  EXPECT_EQ(run({"new", in_folder("b"), "--reference", "scene"}).exit_code, 2);
}

// Meshes are found where `demo` finds its study, wherever the program runs.
TEST_F(New, MeshesComeFromWhereTheDataOfTheProgramIs) {
  const fs::path data = in_folder("data-folder");
  fs::create_directories(data / "data");
  fs::copy(fs::path(source_folder()) / "data/meshes", data / "data/meshes");
  ::setenv("PALPATE_DATA", data.c_str(), 1);
  EXPECT_EQ(run({"new", in_folder("mine")}).exit_code, 0);
  fs::remove(data / "data/meshes/rectum.msh");
  const Outcome missing = run({"new", in_folder("other")});
  ::unsetenv("PALPATE_DATA");
  EXPECT_EQ(missing.exit_code, 1);
  EXPECT_THAT(missing.err, HasSubstr("data/meshes/rectum.msh: no such file"));
  EXPECT_FALSE(fs::exists(in_folder("other")));
}

// Made by `palpate new --reference scene > docs/scene.md`, and so on.
TEST(Reference, ThePagesOfTheFilesAreUpToDate) {
  for (const auto& [name, page] :
       {std::pair{"scene", "scene.md"}, {"protocol", "protocol.md"}, {"observer", "observers.md"}})
    EXPECT_EQ(run({"new", "--reference", name}).out, text_of(source_folder() + "/docs/" + page))
        << "palpate new --reference " << name << " > docs/" << page;
}

/// The whole file that a page begins with.
std::string whole_file_of(const std::string& page) {
  const std::string text = text_of(source_folder() + "/docs/" + page), fence = "```toml\n";
  const auto from = text.find(fence) + fence.size();
  return text.substr(from, text.find("```", from) - from);
}

TEST_F(New, TheWholeFilesOfTheReferenceAreAccepted) {
  const std::string study = in_folder("mine");
  ASSERT_EQ(run({"new", study}).exit_code, 0);
  std::ofstream(study + "/scene.toml") << whole_file_of("scene.md");
  std::ofstream(study + "/protocol.toml") << whole_file_of("protocol.md");
  std::ofstream(study + "/observer.toml") << whole_file_of("observers.md");
  EXPECT_EQ(run({"check", study + "/scene.toml"}).exit_code, 0);
  const Outcome checked = run({"check", study + "/protocol.toml"});
  EXPECT_EQ(checked.exit_code, 0) << checked.err;
  const Outcome observer = run({"check", study + "/observer.toml"});
  EXPECT_EQ(observer.exit_code, 0) << observer.err;
  EXPECT_THAT(observer.out,
              HasSubstr("my-observers: sound simulated examinees, right in 75 % where stiffness "
                        "differs by 23 %"));
  const Outcome played = run({"simulate", study + "/protocol.toml", "--study", in_folder("s.db"),
                              "--examinees", "1", "--observer", study + "/observer.toml"});
  EXPECT_EQ(played.exit_code, 0) << played.err;
}

}  // namespace
}  // namespace palpate::test
