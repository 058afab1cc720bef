#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>

#include "analysis/report/svg.hpp"
#include "analysis/report/write_report.hpp"
#include "tests/analysis/report/fixture.hpp"
#include "tests/support/places.hpp"

using namespace palpate::analysis;
using nlohmann::ordered_json;
using testing::HasSubstr;
using testing::Not;

namespace {

StudyTable paper_with_everything() {
  StudyTable table = test::study_table(test::like_the_paper());
  test::add_curves(table);
  table.trials[5].voided = true;
  table.trials[5].void_reason = "the <door> slammed & \"rang\"";
  table.notes.push_back("One examinee withdrew; the answers were erased.");
  return table;
}

const ReportOptions kOptions{
    .software_version = "0.1.0", .written_utc = "2026-11-22T12:00:00Z", .receipt = "120-0123456789abcdef"};

std::vector<StudyReport> reports_of_all_kinds() {
  std::vector<StudyReport> reports{analyse(paper_with_everything(), kOptions)};
  auto few = test::like_the_paper();
  few.resize(3);
  reports.push_back(analyse(test::study_table(few)));
  reports.push_back(analyse(test::study_table(few), {.interim = true}));
  reports.push_back(analyse(test::study_table(std::vector<std::vector<int>>(15, {0, 4}), 4, "simulated")));
  reports.push_back(analyse(test::study_table(std::vector<std::vector<int>>(200, {3, 2}))));
  StudyTable none = test::study_table({{0, 0}});
  none.trials.clear();
  reports.push_back(analyse(none, {.interim = true}));
  StudyTable strange = paper_with_everything();
  strange.design.cells[0].name = "<script>alert('x')</script>";
  strange.design.question = "a & b < c \x01\xff?";
  strange.sessions[2].examinee = "\"><img src=x>";
  strange.design.side = "two-sided";
  reports.push_back(analyse(strange));
  return reports;
}

}  // namespace

TEST(TextReport, IsAsItWasReviewed) {
  // The file was read line by line against the numbers; make it anew with PALPATE_REWRITE_GOLDEN=1, and read
  // it again.
  const std::filesystem::path golden =
      std::filesystem::path(palpate::test::source_folder()) / "tests/analysis/report/paper.txt";
  const std::string text = text_report(analyse(paper_with_everything(), kOptions));
  if (std::getenv("PALPATE_REWRITE_GOLDEN") != nullptr) std::ofstream(golden) << text;
  std::ostringstream expected;
  expected << std::ifstream(golden).rdbuf();
  EXPECT_EQ(text, expected.str());
}

// Without feedback nothing is said of it, in no format.
TEST(Reports, TellOfFeedbackWhereItWasGiven) {
  StudyTable table = test::study_table(test::like_the_paper());
  const StudyReport without = analyse(table);
  EXPECT_THAT(html_report(without) + text_report(without) + json_report(without).dump(),
              Not(HasSubstr("eedback")));
  table.design.feedback_s = 3.0;
  const StudyReport with = analyse(table);
  EXPECT_THAT(text_report(with), HasSubstr("Feedback was given: after each answer"));
  EXPECT_EQ(json_report(with).at("design").at("feedback_s"), 3.0);
  for (ReportedSession& session : table.sessions) session.run_mode = "simulated";
  EXPECT_THAT(text_report(analyse(table)), HasSubstr("simulated examinees are not told"));
}

// What a terminal gets by itself.
TEST(TextReport, InShortIsAScreenful) {
  for (const StudyReport& report : reports_of_all_kinds()) {
    const std::string text = brief_report(report);
    EXPECT_LE(std::ranges::count(text, '\n'), 40) << text;
    EXPECT_THAT(text, HasSubstr(report.withheld ? "Results are withheld" : "verdict"));
  }
}

TEST(TextReport, LetsNoNameSteerTheTerminal) {
  for (const StudyReport& report : reports_of_all_kinds()) {
    for (const char c : text_report(report)) {
      EXPECT_TRUE(c == '\n' || (static_cast<unsigned char>(c) >= 0x20 && c != 0x7f));
    }
  }
}

TEST(JsonReport, HasTheFieldsThatScriptsRelyOn) {
  const ordered_json json =
      ordered_json::parse(json_report(analyse(paper_with_everything(), kOptions)).dump());
  const auto expect_type = [](const ordered_json& object, const char* key, ordered_json::value_t type) {
    ASSERT_TRUE(object.contains(key)) << key;
    const ordered_json& value = object[key];
    const bool number = type == ordered_json::value_t::number_float && value.is_number();
    EXPECT_TRUE(number || value.type() == type) << key << " is " << value.type_name();
  };
  using Type = ordered_json::value_t;
  for (const char* key : {"run_mode", "channel", "software_version", "written_utc", "receipt"})
    expect_type(json, key, Type::string);
  for (const char* key : {"pseudo_haptic", "interim", "withheld"}) expect_type(json, key, Type::boolean);
  for (const char* key : {"planned_examinees", "complete_examinees"})
    expect_type(json, key, Type::number_float);
  for (const char* key : {"banners", "summary", "cells", "comparisons", "stimuli", "force_curves", "voided",
                          "method", "limits", "sessions"}) {
    expect_type(json, key, Type::array);
  }
  for (const char* key : {"protocol", "design", "claims"}) expect_type(json, key, Type::object);
  const ordered_json& cell = json["cells"][1];
  EXPECT_EQ(cell["cell"], "sibille");
  EXPECT_EQ(cell["correct"], 30);  // 31, but for the voided trial
  EXPECT_EQ(cell["significant"], false);
  for (const char* key : {"primary", "critical", "examinee_level", "dprime", "interval_order"}) {
    expect_type(cell, key, Type::object);
  }
  EXPECT_EQ(cell["critical"]["at_least"], 37);
  for (const char* key : {"proportion", "p", "chance"}) expect_type(cell["primary"], key, Type::number_float);
  for (const char* key : {"lower", "upper", "level"})
    expect_type(cell["primary"]["interval"], key, Type::number_float);
  expect_type(cell["primary"]["p_values"], "two_sided", Type::number_float);
  EXPECT_EQ(cell["by_examinee"].size(), 15u);
  EXPECT_EQ(json["force_curves"].size(), 4u);
}

TEST(JsonReport, HoldsNoTestWhereTestsAreWithheld) {
  auto few = test::like_the_paper();
  few.resize(3);
  const ordered_json json = json_report(analyse(test::study_table(few)));
  EXPECT_TRUE(json["withheld"].get<bool>());
  for (const char* key :
       {"primary", "critical", "examinee_level", "dprime", "interval_order", "significant"}) {
    EXPECT_TRUE(json["cells"][0][key].is_null()) << key;
  }
  EXPECT_TRUE(json["comparisons"].empty() && json["stimuli"].empty() && json["force_curves"].empty());
  EXPECT_TRUE(json["cells"][0]["correct"].is_null());
  EXPECT_TRUE(json["cells"][0]["by_examinee"][0]["correct"].is_null());
  EXPECT_EQ(json["cells"][0]["trials"], 12);
}

// Whoever leads the sittings must not know how they come out.
TEST(Report, SaysTheSameWhateverIsAnsweredBeforeTheSampleIsComplete) {
  const std::vector<std::vector<int>> all_right(3, {4, 4}), all_wrong(3, {0, 0});
  const StudyReport right = analyse(test::study_table(all_right)),
                    wrong = analyse(test::study_table(all_wrong));
  EXPECT_EQ(text_report(right), text_report(wrong));
  EXPECT_EQ(html_report(right), html_report(wrong));
  EXPECT_EQ(json_report(right), json_report(wrong));
  EXPECT_THAT(text_report(right), HasSubstr("Answers so far"));
}

TEST(HtmlReport, StandsAloneAndEscapesWhatComesFromFiles) {
  for (const StudyReport& report : reports_of_all_kinds()) {
    const std::string html = html_report(report);
    EXPECT_THAT(html, Not(HasSubstr("<script")));
    EXPECT_THAT(html, Not(HasSubstr("http:")));
    EXPECT_THAT(html, Not(HasSubstr("https:")));
    EXPECT_THAT(html, Not(HasSubstr("<img")));
    EXPECT_THAT(html, Not(HasSubstr("<link")));
    EXPECT_THAT(html, Not(HasSubstr("url(")));
    EXPECT_THAT(html, Not(HasSubstr("@import")));
    // no number that is none slipped into a picture or a table
    EXPECT_FALSE(std::regex_search(html, std::regex("[=\"> ML]-?(nan|inf)[ \"<LZ%]")));
  }
}

TEST(HtmlReport, FoldsWhatFewRead) {
  const std::string html = html_report(analyse(paper_with_everything(), kOptions));
  EXPECT_THAT(html, HasSubstr("<details><summary>Sessions (15 rows)</summary>"));
  EXPECT_THAT(html, HasSubstr("15 sessions, of which 15 are finished, begun on 2003-12-03 09:30:00 UTC."));
  EXPECT_LT(html.find("<caption>Verdict</caption>"), html.find("completed the study"));
}

// Tables of many rows stand in the page as compressed CSV files.
TEST(HtmlReport, OfManyExamineesStaysSmall) {
  std::vector<std::vector<int>> correct;
  for (int i = 0; i < 12'500; ++i) correct.push_back({i % 5, (i * i) % 5});
  StudyTable table = test::study_table(correct);
  for (std::size_t i = 0; i < table.sessions.size(); ++i) {  // a sitting every seven minutes and some
    const std::size_t s = 437 * i;
    table.sessions[i].started_utc =
        fmt::format("2026-{:02}-{:02}T{:02}:{:02}:{:02}.{:03}Z", 1 + s / 86400 / 28, 1 + s / 86400 % 28,
                    s / 3600 % 24, s / 60 % 60, s % 60, i * 7 % 1000);
  }
  const std::string html = html_report(analyse(table, kOptions));
  EXPECT_LT(html.size(), 500'000u);
  EXPECT_THAT(html, HasSubstr("download=\"sessions.csv.gz\" href=\"data:application/gzip;base64,"));
  EXPECT_THAT(html, HasSubstr("download=\"examinees.csv.gz\""));
}

// Texts that stand at the left end at their place, those of a legend begin there; letters are 6 pixels or more.
TEST(HtmlReport, CutsNoNameOff) {
  StudyTable table = test::study_table(test::like_the_paper());
  table.design.cells[0].name = "a wall of two megapascals, near";
  table.design.cells[1].name = "a wall of twenty megapascals, far away";
  const std::string html = html_report(analyse(table));
  const std::regex picture("<svg[^>]*viewBox=\"0 0 ([0-9.]+) [^]*?</svg>"),
      text("<text x=\"([0-9.]+)\"[^>]*text-anchor=\"(start|end)\"[^>]*>([^<]*)<");
  int seen = 0;
  for (std::sregex_iterator p(html.begin(), html.end(), picture), none; p != none; ++p) {
    const std::string drawn = p->str();
    for (std::sregex_iterator t(drawn.begin(), drawn.end(), text); t != none; ++t) {
      const double x = std::stod((*t)[1]), width = 6.0 * static_cast<double>((*t)[3].length());
      EXPECT_TRUE((*t)[2] == "end" ? x >= width : x + width <= std::stod((*p)[1])) << (*t)[3];
      ++seen;
    }
  }
  EXPECT_GT(seen, 20);
}

TEST(HtmlReport, IsWellFormed) {
  ASSERT_EQ(std::system("command -v xmllint > /dev/null"), 0)
      << "install libxml2-utils, as packages.txt says";
  const std::filesystem::path file = std::filesystem::temp_directory_path() / "palpate_html_report_test.html";
  for (const StudyReport& report : reports_of_all_kinds()) {
    std::ofstream(file) << html_report(report);
    EXPECT_EQ(std::system(("xmllint --noout '" + file.string() + "'").c_str()), 0) << report.run_mode;
  }
  std::filesystem::remove(file);
}

TEST(HtmlReport, CarriesItsBannersAndItsPictures) {
  const std::string html = html_report(analyse(test::study_table(test::like_the_paper(), 4, "simulated")));
  EXPECT_THAT(html, HasSubstr("kuroda2003 | SIMULATED"));  // at the head of every printed page
  EXPECT_THAT(html, HasSubstr("SIMULATED: no person took part"));
  EXPECT_THAT(html, HasSubstr("37 or more"));
  EXPECT_THAT(html, HasSubstr("aria-labelledby=\"answers-title answers-text\""));
}

// The examinee's first sitting is 1 here as it is in the exports, whoever sat before.
TEST(JsonReport, NumbersSittingsAsTheExportsDo) {
  const ordered_json json = json_report(analyse(paper_with_everything(), kOptions));
  ASSERT_EQ(json["sessions"].size(), 15u);
  for (const ordered_json& session : json["sessions"]) EXPECT_EQ(session["session"], 1);
  EXPECT_EQ(json["voided"][0]["session"], 1);
}

// What a study with people and a device has: orders, response times, the loop's timing, each with its
// picture.
TEST(HtmlReport, ShowsOrdersResponseTimesAndTheLoop) {
  StudyTable table = test::study_table(test::like_the_paper());
  for (std::size_t i = 0; i < table.trials.size(); ++i) {
    table.trials[i].response_time_s = 0.8 + 0.02 * static_cast<double>(i % 37);
    for (IntervalRow& interval : table.trials[i].intervals) {
      interval.loop_p999_ms = 1.0 + 0.001 * static_cast<double>(i);
      interval.missed_cycles = i == 7 ? 3 : 0;
      interval.force_error_bound_n = 0.0004 + (i == 7 ? 0.0125 : 0.0);
      interval.cycles_within_tolerance = 0;
      interval.cycles_at_cap = i == 7 ? 17 : 0;
    }
  }
  const std::string html = html_report(analyse(table));
  for (const char* picture : {"orders-title", "times-picture-title", "loop-title"})
    EXPECT_THAT(html, HasSubstr(picture));
  EXPECT_THAT(html, HasSubstr("hard first: 28 of 30"));
  EXPECT_THAT(html, HasSubstr("3 missed cycles"));
  EXPECT_THAT(html, HasSubstr(">12.9<"));  // mN, the worst interval's bound
  EXPECT_THAT(html, HasSubstr("ended at its cap on iterations in 34 cycles"));
  const std::string simulated =
      html_report(analyse(test::study_table(test::like_the_paper(), 4, "simulated")));
  EXPECT_THAT(simulated, Not(HasSubstr("loop-title")));  // a loop that did not run in real time has no timing
}

TEST(Svg, TicksAreRoundAndCoverTheAxis) {
  const Axis axis = nice_axis(0, 2.73, 5, true, "force (N)");
  EXPECT_EQ(axis.ticks, (std::vector<double>{0, 1, 2, 3}));
  EXPECT_EQ(axis.decimals, 0);
  const Axis small = nice_axis(0, 0.004, 4, true, "");
  EXPECT_EQ(small.decimals, 3);
  EXPECT_EQ(small.ticks.size(), 5u);
  EXPECT_EQ(nice_axis(3, 3, 5, true, "").ticks.empty(), false);  // an empty range is widened
}

TEST(Svg, EscapesEverythingThatCouldBeMarkup) {
  EXPECT_EQ(escape("<a href=\"x\">'&'</a>\x01\xC3\xA9\xFF"),
            "&lt;a href=&quot;x&quot;&gt;&#39;&amp;&#39;&lt;/a&gt; \xC3\xA9\xEF\xBF\xBD");
}
