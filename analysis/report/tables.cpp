#include "analysis/report/tables.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "analysis/report/summary.hpp"
#include "analysis/words/words.hpp"

namespace palpate::analysis {
namespace {

const std::string kNone = "n/a";

std::string of(long correct, long trials) {
  return fmt::format("{} of {}", correct, trials);
}

std::string optional_number(const std::optional<double>& value, double scale = 1.0) {
  return value ? number(scale * *value) : kNone;
}

std::string bare_p(double p) {  // for a column headed "p"
  const std::string words = p_in_words(p);
  return words.starts_with("p = ") ? words.substr(4) : words.substr(2);
}

std::string order_cell(long correct, long trials) {
  if (trials == 0) return "none";
  return fmt::format("{} ({})", of(correct, trials),
                     percent(static_cast<double>(correct) / static_cast<double>(trials)));
}

// An examinee's counted answers; where none is counted, all, and that they are not.
std::string counts_of(const CellResult& cell, std::size_t examinee) {
  const ExamineeCount& counted = cell.by_examinee[examinee];
  if (counted.trials > 0 || !cell.all) return of(counted.correct, counted.trials);
  const ExamineeCount& all = cell.all->by_examinee[examinee];
  return of(all.correct, all.trials) + (all.trials > 0 ? ", not counted" : "");
}

}  // namespace

TextTable answers_table(const StudyReport& report) {
  TextTable table{.title = "Answers so far", .header = {"examinee"}};
  for (const CellResult& cell : report.cells) table.header.push_back(cell.name);
  std::vector<std::string> all{"all"};
  for (const CellResult& cell : report.cells) all.push_back(std::to_string(cell.trials));
  table.rows.push_back(all);
  for (std::size_t i = 0; i < report.examinees.size(); ++i) {
    std::vector<std::string> row{report.examinees[i]};
    for (const CellResult& cell : report.cells) row.push_back(std::to_string(cell.by_examinee[i].trials));
    table.rows.push_back(row);
  }
  return table;
}

TextTable primary_table(const StudyReport& report) {
  const std::string level = short_percent(report.options.level);
  const bool one_sided = report.design.side != "two-sided";
  TextTable table{.title = "Correct answers, all examinees together",
                  .header = {"cell", "correct", "%", "rejects guessing", "p", level + " interval"}};
  if (one_sided) table.header.push_back(level + " bound");
  for (const CellResult& cell : report.cells) {
    std::vector<std::string> row{
        cell.name, of(cell.correct, cell.trials),
        cell.trials == 0 ? kNone
                         : percent(static_cast<double>(cell.correct) / static_cast<double>(cell.trials))};
    if (cell.primary) {
      const std::string region = region_in_words(cell.primary->critical);
      row.push_back(region.empty() ? "no number" : region.substr(0, region.find(" correct")));
      row.push_back(bare_p(cell.primary->p.of(cell.primary->side)));
      row.push_back(percent_range(cell.primary->interval));
      if (report.design.side == "greater") row.push_back("at least " + percent(cell.primary->bound.lower));
      if (report.design.side == "less") row.push_back("at most " + percent(cell.primary->bound.upper));
    }
    row.resize(table.header.size(), kNone);
    table.rows.push_back(row);
  }
  table.note = fmt::format("{} against 1/2, alpha {}, side {}.", primary_in_words(report.design),
                           report.design.alpha, report.design.side);
  if (report.look && report.look->of > 1) {
    table.note += fmt::format(" Look {} of {}: the region of rejection is that of {} spending.",
                              report.look->number, report.look->of, report.design.spending);
  }
  table.note += " Intervals are two-sided Clopper-Pearson intervals";
  if (report.design.primary != "paired-comparison") {
    table.note += ", which take the answers for independent.";
  } else {
    table.note += one_sided ? "; the one-sided bound beside them is the one that belongs to the test, so a "
                              "result may be significant though the two-sided interval just includes 50 %."
                            : ".";
  }
  return table;
}

TextTable people_table(const StudyReport& report) {
  TextTable table{.title = "Correct answers, examinee by examinee",
                  .header = {"cell", "examinees", "mean", "standard deviation",
                             report.design.side == "two-sided" ? "two-sided p" : "one-sided p",
                             short_percent(report.options.level) + " interval of the mean"}};
  std::set<std::string> tests, intervals;
  for (const CellResult& cell : report.cells) {
    std::vector<std::string> row{cell.name};
    if (cell.by_people) {
      const ExamineeLevelTest& test = *cell.by_people;
      row.insert(row.end(),
                 {std::to_string(test.examinees), percent(test.mean_proportion),
                  test.examinees > 1 ? percent(test.deviation) : kNone,
                  bare_p(test.p.of(side_from_name(report.design.side))), percent_range(test.interval)});
      tests.insert(test.test.method.name);
      if (!std::isnan(test.interval.lower)) intervals.insert(test.interval.method);
    }
    row.resize(table.header.size(), kNone);
    table.rows.push_back(row);
  }
  if (!tests.empty()) {
    table.note = fmt::format("Each examinee's proportion correct against 1/2, side {}: {}",
                             report.design.side, listed({tests.begin(), tests.end()}));
    table.note += intervals.empty()
                      ? "."
                      : fmt::format("; intervals by {}.", listed({intervals.begin(), intervals.end()}));
  }
  return table;
}

TextTable comparison_table(const StudyReport& report) {
  const auto label = [&](const std::string& name, const std::string& key) {
    return name + (report.design.between_models == key ? ": p (planned)" : ": p (secondary)");
  };
  TextTable table{.title = "Cell against cell, within examinees",
                  .header = {"cells", "examinees", "mean difference (points)",
                             short_percent(report.options.level) + " interval",
                             label("sign-flip", "sign-flip"), label("Wilcoxon", "wilcoxon")}};
  for (const CellComparison& comparison : report.comparisons) {
    std::vector<std::string> row{fmt::format("{} - {}", comparison.first, comparison.second),
                                 std::to_string(comparison.examinees)};
    row.push_back(comparison.examinees > 0 ? fmt::format("{:+.1f}", 100 * comparison.mean_difference + 0.0)
                                           : kNone);
    if (comparison.sign_flip) {
      row.push_back(points_range(comparison.sign_flip->interval));
      row.push_back(bare_p(comparison.sign_flip->p.two_sided));
    }
    if (comparison.signed_rank) row.push_back(bare_p(comparison.signed_rank->p.two_sided));
    row.resize(table.header.size(), kNone);
    table.rows.push_back(row);
  }
  table.note = "Differences of proportions correct in percentage points; p values are two-sided.";
  return table;
}

TextTable sensitivity_table(const StudyReport& report) {
  const std::string correct =
      report.design.correct_condition.empty() ? "correct condition" : report.design.correct_condition;
  TextTable table{.title = "d', and correct answers by the interval that held the correct condition",
                  .header = {"cell", "d'", short_percent(report.options.level) + " interval", "d' by order",
                             correct + " first", correct + " second", "answers '1'", "p (against 1/2)"}};
  bool corrected = false;
  for (const CellResult& cell : report.cells) {
    std::vector<std::string> row{cell.name};
    if (cell.d_prime && cell.bias) {
      const IntervalBias& bias = *cell.bias;
      const bool by_order = bias.d_prime && bias.d_prime->corrected;
      corrected = corrected || cell.d_prime->corrected || by_order;
      row.insert(row.end(),
                 {decimals(cell.d_prime->d_prime, 2) + (cell.d_prime->corrected ? " *" : ""),
                  range(cell.d_prime->interval, [](double value) { return decimals(value, 2); }),
                  bias.d_prime ? decimals(bias.d_prime->d_prime, 2) + (by_order ? " *" : "") : kNone,
                  order_cell(bias.counts.correct_first, bias.counts.trials_first),
                  order_cell(bias.counts.correct_second, bias.counts.trials_second),
                  percent(bias.share_first), bare_p(bias.p.two_sided)});
    }
    row.resize(table.header.size(), kNone);
    table.rows.push_back(row);
  }
  table.note =
      "d' = sqrt(2) z(proportion correct) for an observer without a preferred interval; 'd' by order' does "
      "without that assumption. Correct answers are given by the interval that held the correct condition; "
      "the share of answers '1' is tested against 1/2, two-sided.";
  if (corrected) table.note += " * 0 or 100 % corrected by 1/(2n) (Macmillan & Kaplan 1985).";
  return table;
}

TextTable response_time_table(const StudyReport& report) {
  TextTable table{
      .title = "Response times",
      .header = {"cell", "answers", "least", "lower quartile", "median", "upper quartile", "most"}};
  for (const CellResult& cell : report.cells) {
    if (!cell.response_times) continue;
    const ResponseTimes& times = *cell.response_times;
    table.rows.push_back({cell.name, std::to_string(times.n), decimals(times.least, 2),
                          decimals(times.lower_quartile, 2), decimals(times.median, 2),
                          decimals(times.upper_quartile, 2), decimals(times.most, 2)});
  }
  table.note = "Seconds from the question's onset to the answer.";
  return table;
}

TextTable examinee_table(const StudyReport& report) {
  TextTable table{.title = "Correct answers of each examinee", .header = {"examinee"}};
  for (const CellResult& cell : report.cells) table.header.push_back(cell.name);
  for (std::size_t i = 0; i < report.examinees.size(); ++i) {
    std::vector<std::string> row{report.examinees[i]};
    for (const CellResult& cell : report.cells) row.push_back(counts_of(cell, i));
    table.rows.push_back(row);
  }
  return table;
}

TextTable stimulus_table(const StudyReport& report) {
  TextTable table{
      .title = "Stimuli as they were explored",
      .header = {"cell, condition", "intervals", "presses", "time (s)",
                 report.pseudo_haptic ? "peak force (N), not displayed" : "peak force (N)", "depth (mm)",
                 "clamped, at worst", "loop p99.9 (ms), at worst", "missed cycles"}};
  for (const StimulusSummary& stimulus : report.stimuli) {
    table.rows.push_back(
        {fmt::format("{}, {}", stimulus.cell, stimulus.condition), std::to_string(stimulus.intervals),
         decimals(stimulus.mean_presses, 1), optional_number(stimulus.mean_exploration_s),
         optional_number(stimulus.mean_peak_force_n), optional_number(stimulus.mean_max_depth_m, 1000),
         stimulus.worst_clamped_fraction ? percent(*stimulus.worst_clamped_fraction) : kNone,
         optional_number(stimulus.worst_loop_p999_ms),
         stimulus.missed_cycles ? std::to_string(*stimulus.missed_cycles) : kNone});
  }
  table.note =
      "Means over intervals, but for the worst values and the sum of missed cycles. A loop that did not run "
      "in real time (simulated examinees) has no timing.";
  return table;
}

TextTable voided_table(const StudyReport& report) {
  TextTable table{.title = "Voided trials, not counted",
                  .header = {"examinee", "session", "trial", "cell", "reason"}};
  for (const VoidedTrial& trial : report.voided) {
    table.rows.push_back({trial.examinee, std::to_string(trial.session), std::to_string(trial.trial),
                          trial.cell, trial.reason});
  }
  return table;
}

/// "0.1.0, then 0.2.0" of a session that another version took up again.
std::string versions_of(const ReportedSession& session) {
  std::string versions = session.software_version;
  for (const std::string& later : session.later_versions)
    if (later != session.software_version) versions += ", then " + later;
  return versions;
}

TextTable session_table(const StudyReport& report) {
  TextTable table{.title = "Sessions",
                  .header = {"examinee", "session", "begun (UTC)", "finished", "resumed", "device",
                             "order from", "version"}};
  const bool scaled = std::ranges::any_of(
      report.sessions, [](const ReportedSession& session) { return session.force_scale != 1.0; });
  if (scaled) table.header.push_back("force scale");
  for (const ReportedSession& session : report.sessions) {
    table.rows.push_back({session.examinee, std::to_string(session.session), session.started_utc,
                          session.finished ? "yes" : "no", std::to_string(session.times_resumed),
                          session.device, session.order_source, versions_of(session)});
    if (scaled) table.rows.back().push_back(number(session.force_scale));
  }
  return table;
}

TextTable curve_table(const StudyReport& report) {
  TextTable table{.title = report.pseudo_haptic ? "Mean force (N) over depth, computed and not displayed"
                                                : "Mean force (N) over depth",
                  .header = {"depth (mm)"}};
  std::map<double, std::vector<std::string>> rows;  // by depth: curves need not share an axis
  for (const ForceCurve& curve : report.curves) {
    for (const double depth : curve.depth_m)
      rows.try_emplace(depth, std::vector<std::string>(report.curves.size(), ""));
  }
  for (std::size_t c = 0; c < report.curves.size(); ++c) {
    const ForceCurve& curve = report.curves[c];
    table.header.push_back(fmt::format("{}, {} (n = {})", report.design.cells[curve.cell].name,
                                       curve.condition, curve.intervals));
    for (std::size_t i = 0; i < curve.depth_m.size(); ++i) {
      std::string& text = rows.at(curve.depth_m[i])[c];
      text = decimals(curve.mean_force_n[i], 3);
      if (!curve.deviation_n.empty()) text += " ± " + decimals(curve.deviation_n[i], 3);
    }
  }
  for (const auto& [depth, values] : rows) {
    table.rows.push_back({number(1000 * depth)});
    table.rows.back().insert(table.rows.back().end(), values.begin(), values.end());
  }
  table.note = "Mean ± standard deviation between presses.";
  return table;
}

}  // namespace palpate::analysis
