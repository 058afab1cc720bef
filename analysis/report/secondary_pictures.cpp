#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "analysis/report/pictures.hpp"
#include "analysis/report/rows_picture.hpp"
#include "analysis/words/words.hpp"

namespace palpate::analysis {
namespace {

constexpr double kNoReference = std::numeric_limits<double>::quiet_NaN();

PictureRow order_row(const std::string& name, const std::string& order, const Interval& interval,
                     long correct, long trials, std::size_t colour) {
  return {.name = name,
          .note = fmt::format("{}: {} of {}", order, correct, trials),
          .from = 100 * interval.lower,
          .to = 100 * interval.upper,
          .mark = 100 * static_cast<double>(correct) / static_cast<double>(trials),
          .colour = colour};
}

}  // namespace

std::string orders_picture(const StudyReport& report) {
  const std::string& correct = report.design.correct_condition;
  std::vector<PictureRow> rows;
  for (std::size_t c = 0; c < report.cells.size(); ++c) {
    const CellResult& cell = report.cells[c];
    if (!cell.bias) continue;
    const OrderCounts& counts = cell.bias->counts;
    if (counts.trials_first > 0)
      rows.push_back(order_row(cell.name, correct + " first", cell.bias->interval_first, counts.correct_first,
                               counts.trials_first, c));
    if (counts.trials_second > 0)
      rows.push_back(order_row(cell.name, correct + " second", cell.bias->interval_second,
                               counts.correct_second, counts.trials_second, c));
  }
  if (rows.empty()) return "";
  return rows_picture(
      "orders", "Correct answers by the order of the intervals",
      "For each cell and order the percentage correct with its interval; the table gives the counts.", rows,
      nice_axis(0, 100, 5, false, "correct answers (%)"), 50.0);
}

std::string times_picture(const StudyReport& report) {
  std::vector<PictureRow> rows;
  double most = 0.0;
  for (std::size_t c = 0; c < report.cells.size(); ++c) {
    if (!report.cells[c].response_times) continue;
    const ResponseTimes& times = *report.cells[c].response_times;
    most = std::max(most, times.most);
    rows.push_back({.name = report.cells[c].name,
                    .note = counted(static_cast<long>(times.n), "answer", "answers"),
                    .from = times.least,
                    .to = times.most,
                    .box_from = times.lower_quartile,
                    .box_to = times.upper_quartile,
                    .mark = times.median,
                    .colour = c});
  }
  if (rows.empty()) return "";
  return rows_picture("times-picture", "Response times",
                      "For each cell the range, the quartiles and the median; the table gives the numbers.",
                      rows, nice_axis(0, most, 6, true, "response time (s)"), kNoReference);
}

std::string loop_picture(const StudyReport& report) {
  constexpr double kPeriod = 1.0;  // of a loop at 1 kHz [ms]
  std::vector<PictureRow> rows;
  double most = kPeriod;
  for (const StimulusSummary& stimulus : report.stimuli) {
    if (!stimulus.worst_loop_p999_ms) continue;
    const auto cell = std::ranges::find_if(
        report.cells, [&](const CellResult& result) { return result.name == stimulus.cell; });
    most = std::max(most, *stimulus.worst_loop_p999_ms);
    rows.push_back({.name = fmt::format("{}, {}", stimulus.cell, stimulus.condition),
                    .note = fmt::format("{} missed cycles", stimulus.missed_cycles.value_or(0)),
                    .from = kPeriod,
                    .to = *stimulus.worst_loop_p999_ms,
                    .mark = *stimulus.worst_loop_p999_ms,
                    .colour = static_cast<std::size_t>(cell - report.cells.begin())});
  }
  if (rows.empty()) return "";
  return rows_picture(
      "loop", "Timing of the haptic loop",
      "For each stimulus the worst interval's time within which 99.9 percent of cycles followed the "
      "one before; the table gives the numbers.",
      rows, nice_axis(0, most, 6, true, "99.9 % of cycles within (ms), worst interval"), kPeriod);
}

}  // namespace palpate::analysis
