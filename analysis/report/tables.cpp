#include "analysis/report/tables.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "analysis/words/words.hpp"

namespace palpate::analysis {
namespace {

std::string optional_count(const std::optional<long>& value) {
  return value ? std::to_string(*value) : kNotAvailable;
}

std::string optional_number(const std::optional<double>& value, double scale = 1.0) {
  return value ? number(scale * *value) : kNotAvailable;
}

// An examinee's counted answers; where none is counted, all, and that they are not.
std::string counts_of(const CellResult& cell, std::size_t examinee) {
  const ExamineeCount& counted = cell.by_examinee[examinee];
  if (counted.trials > 0 || !cell.all) return out_of(counted.correct, counted.trials);
  const ExamineeCount& all = cell.all->by_examinee[examinee];
  return out_of(all.correct, all.trials) + (all.trials > 0 ? ", not counted" : "");
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

/// How exactly the loop's cycles computed the force, where that was recorded.
void add_solution(const StudyReport& report, TextTable& table) {
  if (std::ranges::none_of(report.stimuli,
                           [](const auto& stimulus) { return stimulus.cycles_at_cap.has_value(); }))
    return;
  for (const char* column : {"force error (mN), at most", "ended early", "at the cap"})
    table.header.push_back(column);
  for (std::size_t i = 0; i < report.stimuli.size(); ++i) {
    const StimulusSummary& stimulus = report.stimuli[i];
    table.rows[i].push_back(optional_number(stimulus.worst_force_error_bound_n, 1000));
    table.rows[i].push_back(optional_count(stimulus.cycles_within_tolerance));
    table.rows[i].push_back(optional_count(stimulus.cycles_at_cap));
  }
  table.note +=
      " Force error: the largest bound of a cycle; its solution of the contact ended early in as many cycles, "
      "within the tolerance that the scene sets, and in others at the cap on iterations.";
}

TextTable stimulus_table(const StudyReport& report) {
  TextTable table{
      .title = "Stimuli as they were explored",
      .header = {"cell, condition", "intervals", "shown again", "presses", "time (s)",
                 report.pseudo_haptic ? "peak force (N), not displayed" : "peak force (N)", "depth (mm)",
                 "clamped, at worst", "loop p99.9 (ms), at worst", "missed cycles"}};
  for (const StimulusSummary& stimulus : report.stimuli) {
    table.rows.push_back(
        {fmt::format("{}, {}", stimulus.cell, stimulus.condition), std::to_string(stimulus.intervals),
         std::to_string(stimulus.shown_again), decimals(stimulus.mean_presses, 1),
         optional_number(stimulus.mean_exploration_s), optional_number(stimulus.mean_peak_force_n),
         optional_number(stimulus.mean_max_depth_m, 1000),
         stimulus.worst_clamped_fraction ? percent(*stimulus.worst_clamped_fraction) : kNotAvailable,
         optional_number(stimulus.worst_loop_p999_ms), optional_count(stimulus.missed_cycles)});
  }
  table.note =
      "Means over intervals, but for the worst values and the sum of missed cycles. Shown again: presentations "
      "that did not count, for they were not explored enough or were cut off. A loop that did not run "
      "in real time (simulated examinees) has no timing.";
  add_solution(report, table);
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
    table.rows.push_back({session.examinee, std::to_string(session.session),
                          to_the_second(session.started_utc), session.finished ? "yes" : "no",
                          std::to_string(session.times_resumed), session.device, session.order_source,
                          versions_of(session)});
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
