// Study files of several sites become one.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/end_to_end/program.hpp"
#include "tests/support/places.hpp"
#include "tests/trials/support/files.hpp"

namespace palpate {
namespace {

using nlohmann::json;
using test::Outcome;
using test::run;
using testing::HasSubstr;
using trials::test::read;
using trials::test::TemporaryFolder;

class Merge : public testing::Test {
 protected:
  Merge() {
    const std::string protocol = palpate::test::source_folder() + "/protocols/kuroda2003.toml";
    for (const auto& [name, seed] : {std::pair{"osaka.db", "1"}, std::pair{"kyoto.db", "2"}}) {
      const Outcome made =
          run({"simulate", protocol, "--study", file(name), "--examinees", "2", "--seed", seed});
      EXPECT_EQ(made.exit_code, 0) << made.err;
    }
  }
  std::string file(const std::string& name) const { return (folder_ / name).string(); }
  std::string receipt_of(const std::string& name) const {
    return json::parse(run({"verify", file(name), "--format", "json"}).out).at("receipt");
  }
  std::vector<std::string> join(const std::string& out) const {
    return {
        "merge",    file(out), "--site", "Osaka=" + file("osaka.db"), "--site", "Kyoto=" + file("kyoto.db"),
        "--format", "json"};
  }

  TemporaryFolder folder_;
};

TEST_F(Merge, JoinsTwoSites) {
  const Outcome merged = run(join("all.db"));
  ASSERT_EQ(merged.exit_code, 0) << merged.err;
  const json said = json::parse(merged.out);
  EXPECT_EQ(said.at("parts").at(1).at("site"), "Kyoto");
  EXPECT_EQ(said.at("parts").at(1).at("receipt"), receipt_of("kyoto.db"));
  for (const std::string& receipt : {receipt_of("osaka.db"), receipt_of("kyoto.db"), receipt_of("all.db")}) {
    const Outcome verified = run({"verify", file("all.db"), "--receipt", receipt});
    EXPECT_EQ(verified.exit_code, 0) << verified.out;
    EXPECT_THAT(verified.out, HasSubstr("joined from kyoto.db (site Kyoto): 2 sittings"));
  }
  const json report = json::parse(
      run({"report", file("all.db"), "--run-mode", "simulated", "--interim", "--format", "json"}).out);
  EXPECT_EQ(report.at("complete_examinees"), 4);
  EXPECT_EQ(run({"export", file("all.db"), "--as", "bids", "--out", file("bids")}).exit_code, 0);
  EXPECT_TRUE(std::filesystem::exists(folder_ / "bids/sub-KyotoS01"));
}

TEST_F(Merge, KeepsTheFrozenPlanOfEverySite) {
  const std::string protocol = palpate::test::source_folder() + "/protocols/kuroda2003.toml";
  for (const auto& [name, seed] : {std::pair{"osaka.db", "1"}, std::pair{"kyoto.db", "2"}}) {
    std::filesystem::remove(file(name));
    ASSERT_EQ(run({"plan", protocol, "--freeze", file(name)}).exit_code, 0);
    ASSERT_EQ(
        run({"simulate", protocol, "--study", file(name), "--examinees", "1", "--seed", seed}).exit_code, 0);
  }
  ASSERT_EQ(run(join("all.db")).exit_code, 0);
  const json plan =
      json::parse(
          run({"report", file("all.db"), "--run-mode", "simulated", "--interim", "--format", "json"}).out)
          .at("plan");
  ASSERT_EQ(plan.at("frozen_plans").size(), 2U);
  EXPECT_EQ(plan.at("frozen_plans").at(0).at("frozen_in"), "the study file osaka.db of the site Osaka");
  EXPECT_EQ(plan.at("frozen_plans").at(1).at("frozen_in"), "the study file kyoto.db of the site Kyoto");
  EXPECT_EQ(plan.at("frozen"), plan.at("frozen_plans").at(0));
}

TEST_F(Merge, RefusesEqualCodesAndTakenNames) {
  const Outcome clash = run({"merge", file("all.db"), file("osaka.db"), file("kyoto.db")});
  EXPECT_EQ(clash.exit_code, 1);
  EXPECT_THAT(clash.err, HasSubstr("--site NAME=FILE"));
  EXPECT_FALSE(std::filesystem::exists(file("all.db")));
  const std::string before = read(folder_ / "osaka.db");
  const Outcome forgotten = run({"merge", file("osaka.db"), file("kyoto.db")});  // no name for the new file
  EXPECT_EQ(forgotten.exit_code, 1);
  EXPECT_THAT(forgotten.err, HasSubstr("is there already and is not overwritten"));
  EXPECT_EQ(read(folder_ / "osaka.db"), before);
  EXPECT_EQ(run({"merge", file("all.db"), "--site", "Osaka"}).exit_code, 1);
}

TEST_F(Merge, AFullDiskLeavesNothing) {
  std::string command = std::string("ulimit -f 100; exec ") + palpate::test::program_file();
  for (const std::string& word : join("all.db")) command += " " + word;
  command += " 2> " + file("said");
  const int status = std::system(("bash -c \"" + command + "\" > /dev/null").c_str());
  EXPECT_EQ(WEXITSTATUS(status), 3) << read(folder_ / "said");
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder_.path()), {}),
            5);  // two studies with their heads, what was said
}

}  // namespace
}  // namespace palpate
