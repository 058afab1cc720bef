#include "trials/tables/table.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/trials/support/protocols.hpp"
#include "tests/trials/support/sitting.hpp"
#include "trials/tables/delimited.hpp"

namespace palpate::trials {
namespace {

std::vector<std::string> names(const Table& table) {
  std::vector<std::string> found;
  for (const Column& column : table.columns) found.push_back(column.name);
  return found;
}

class TableTest : public testing::Test {
 protected:
  TableTest() : study_(open_study(folder_ / "study.db", protocol_, "0.1.0")) {
    Session session = start_session(study_, protocol_, test::facts_of("P01"));
    session.begin_interval();
    session.end_interval(test::press_to(1e-3));  // too shallow: does not count
    session.begin_interval();
    session.interrupt(test::press_to(1e-3), "test");
    test::answer_all(session);
    EventRow event{.session = session.row().id, .trial = 2, .kind = "voided"};
    event.text = "the \"alarm\" rang, loudly";
    study_.add_event(event);
  }

  Table trials() const { return trial_table(protocol_, answered_trials(study_)); }
  Table intervals() const { return interval_table(protocol_, answered_trials(study_)); }
  Table others() const { return exposure_table(protocol_, exposures(study_)); }

  test::TemporaryFolder folder_;
  Protocol protocol_ = test::small_protocol(2);
  StudyFile study_;
};

TEST_F(TableTest, HaveTheColumnsOfTheTrialLog) {
  EXPECT_EQ(names(trials()),
            (std::vector<std::string>{"participant_id", "session_id", "block", "trial", "run_mode", "task",
                                      "procedure", "contact_model", "correct_answer", "response", "correct",
                                      "response_time_s", "onset_utc", "device", "pseudo_haptic",
                                      "protocol_sha256", "software_version", "voided", "void_reason"}));
  EXPECT_EQ(names(intervals()),
            (std::vector<std::string>{"participant_id", "session_id", "trial", "interval", "condition",
                                      "level_proposed", "level_presented", "n_presses", "exploration_time_s",
                                      "peak_force_n", "max_depth_m", "clamped_fraction", "loop_rate_hz",
                                      "loop_p999_ms", "missed_cycles", "force_error_bound_n",
                                      "cycles_within_tolerance", "cycles_at_cap", "run_mode"}));
}

TEST_F(TableTest, HoldEveryAnswerEveryIntervalAndEveryOtherExposure) {
  EXPECT_EQ(trials().rows.size(), 4U);
  EXPECT_EQ(intervals().rows.size(), 8U);
  const Table not_counted = others();
  ASSERT_EQ(not_counted.rows.size(), 2U);
  const std::size_t why = not_counted.columns.size() - 2;
  EXPECT_EQ(std::get<std::string>(not_counted.rows[0][why]), "not pressed deep enough");
  EXPECT_EQ(std::get<std::string>(not_counted.rows[1][why]), "interrupted");
  for (const Table& table : {trials(), intervals(), not_counted})
    for (const auto& row : table.rows) EXPECT_EQ(row.size(), table.columns.size()) << table.name;
  for (const Table& table : {intervals(), not_counted})
    for (const auto& row : table.rows) EXPECT_EQ(std::get<std::string>(row.back()), "study") << table.name;
}

TEST_F(TableTest, TellWhatExamineesWroteAndWhatCutThemOff) {
  Session session = start_session(study_, protocol_, test::facts_of("P02"));
  session.note(event_kind::kEarlyKey, "2");
  test::answer_all(session);
  session.note(event_kind::kStrategy, "I pushed hard,\nand waited");
  const Table events = event_table(study_.sessions(), study_.events());
  EXPECT_EQ(names(events), (std::vector<std::string>{"participant_id", "session_id", "trial", "event",
                                                     "event_text", "event_utc", "run_mode"}));
  std::vector<std::string> lines;
  for (const auto& row : events.rows)
    lines.push_back(fmt::format("{} {} {} {}", cell_text(row[0]), cell_text(row[2]), cell_text(row[3]),
                                cell_text(row[4])));
  EXPECT_EQ(lines, (std::vector<std::string>{"P01 1 interrupted test", "P02 1 early key 2",
                                             "P02 n/a strategy I pushed hard, and waited"}));
}

TEST_F(TableTest, AreWrittenAsRfc4180) {
  const std::string csv = to_csv(trials());
  EXPECT_EQ(csv.substr(0, 15), "participant_id,");
  EXPECT_NE(csv.find(",1,\"the \"\"alarm\"\" rang, loudly\"\n"), std::string::npos);
  EXPECT_NE(csv.find(",0,n/a\n"), std::string::npos);
  EXPECT_EQ(csv.find('\r'), std::string::npos);
  EXPECT_EQ(std::ranges::count(csv, '\n'), 5);
}

}  // namespace
}  // namespace palpate::trials
