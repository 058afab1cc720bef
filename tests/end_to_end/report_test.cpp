// What a look at the results leaves in the study file.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

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
using trials::test::sql_value;
using trials::test::TemporaryFolder;

class ReportEndToEnd : public testing::Test {
 protected:
  std::string file(const std::string& name) const { return (folder_ / name).string(); }
  void simulate(const std::string& protocol, int examinees) const {
    const Outcome made =
        run({"simulate", palpate::test::source_folder() + "/protocols/" + protocol, "--study", file("a.db"),
             "--examinees", std::to_string(examinees), "--seed", "1"});
    ASSERT_EQ(made.exit_code, 0) << made.err;
  }
  json report(const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments{"report", file("a.db"), "--format", "json"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome shown = run(arguments);
    EXPECT_EQ(shown.exit_code, 0) << shown.err;
    return json::parse(shown.out);
  }
  std::string events(const std::string& kind) const {
    return sql_value(folder_ / "a.db", "SELECT count(*) FROM event WHERE kind = '" + kind + "'");
  }

  TemporaryFolder folder_;
};

TEST_F(ReportEndToEnd, APlannedLookIsLoggedOnceAndIsNotHeldAgainstTheStudy) {
  simulate("kuroda2003-sequential.toml", 10);
  const json first = report({"--interim"});  // asked for, but it was planned
  EXPECT_EQ(events("planned look"), "1");
  const json again = report();
  EXPECT_EQ(events("planned look"), "1");
  EXPECT_EQ(events("interim look"), "0");
  EXPECT_EQ(sql_value(folder_ / "a.db", "SELECT text FROM event WHERE kind = 'planned look'"),
            "run mode simulated, look 1 of 3, 10 of 30 planned examinees complete");
  EXPECT_EQ(again.at("plan").at("unplanned_interim_looks"), 0);
  EXPECT_EQ(again.at("plan").at("planned_looks_taken").at(0).at("number"), 1);
  EXPECT_EQ(again.at("plan").at("planned_looks_taken"), first.at("plan").at("planned_looks_taken"));
  EXPECT_EQ(run({"verify", file("a.db")}).exit_code, 0);
}

TEST_F(ReportEndToEnd, ALookThatCannotBeWrittenIsNotLogged) {
  simulate("kuroda2003.toml", 1);
  const Outcome refused = run({"report", file("a.db"), "--interim", "--out", file("no_folder/report.html")});
  EXPECT_EQ(refused.exit_code, 1);
  EXPECT_THAT(refused.err, HasSubstr("no_folder is not there"));
  EXPECT_EQ(refused.out, "");
  EXPECT_EQ(events("interim look"), "0");
  report({"--interim"});
  EXPECT_EQ(events("interim look"), "1");
  EXPECT_EQ(report().at("plan").at("unplanned_interim_looks"), 1);
}

TEST_F(ReportEndToEnd, NumbersSittingsAsTheExportsDo) {
  simulate("kuroda2003.toml", 2);
  const json shown = report();
  for (const json& session : shown.at("sessions")) EXPECT_EQ(session.at("session"), 1);
}

// A study that tells its examinees whether they were right goes the way of all others.
TEST_F(ReportEndToEnd, AStudyWithFeedbackIsSimulatedReportedVerifiedAndExported) {
  simulate("feel-the-difference.toml", 12);
  const json shown = report();
  EXPECT_EQ(shown.at("design").at("feedback_s"), 3.0);
  for (const json& cell : shown.at("cells")) {
    EXPECT_EQ(cell.at("trials"), 240);
    EXPECT_GT(cell.at("correct"), 180);  // whoever goes by what differs is right
  }
  EXPECT_EQ(run({"verify", file("a.db")}).exit_code, 0);
  for (const std::string kind : {"csv", "json", "psych-ds", "bids"})
    EXPECT_EQ(run({"export", file("a.db"), "--as", kind, "--out", file(kind)}).exit_code, 0) << kind;
  EXPECT_THAT(trials::test::read(folder_ / "psych-ds/README.md"),
              HasSubstr("After each answer the examinee is told whether it was right."));
}

TEST_F(ReportEndToEnd, ATerminalGetsAScreenfulAndWhereTheRestIs) {
  simulate("kuroda2003.toml", 15);
  const Outcome all = run({"report", file("a.db")});
  EXPECT_THAT(all.out, HasSubstr("Limits\n======"));
  const Outcome brief = test::run_on_terminal({"report", file("a.db"), "--out", file("r.html")});
  EXPECT_EQ(brief.exit_code, 0);
  EXPECT_LE(std::ranges::count(brief.out, '\n'), 24);
  EXPECT_THAT(brief.out, HasSubstr("told apart"));
  EXPECT_THAT(brief.out, HasSubstr("All of it: " + file("r.html") + " (open it in a browser), or --full."));
  const Outcome full = test::run_on_terminal({"report", file("a.db"), "--full"});
  EXPECT_THAT(full.out, HasSubstr("Limits"));
}

}  // namespace
}  // namespace palpate
