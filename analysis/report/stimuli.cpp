#include "analysis/report/stimuli.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <tuple>

namespace palpate::analysis {
namespace {

// Mean of what was recorded; empty when nothing was.
struct Mean {
  double sum = 0.0;
  long n = 0;
  void add(const std::optional<double>& value) {
    if (value) sum += *value, ++n;
  }
  std::optional<double> value() const {
    return n == 0 ? std::nullopt : std::optional(sum / static_cast<double>(n));
  }
};

template <typename Value>
void keep_largest(std::optional<Value>& largest, const std::optional<Value>& value) {
  if (value && (!largest || *value > *largest)) largest = value;
}

void count(std::optional<long>& all, const std::optional<long>& more) {
  if (more) all = all.value_or(0) + *more;
}

}  // namespace

std::vector<StimulusSummary> summarise_stimuli(const StudyDesign& design, const Selection& selection) {
  struct Sums {
    StimulusSummary summary{};
    Mean presses{}, exploration{}, force{}, depth{};
  };
  const auto place = [&](const std::string& condition) {  // in the protocol's order
    return std::ranges::find(design.conditions, condition) - design.conditions.begin();
  };
  std::map<std::tuple<std::size_t, std::ptrdiff_t, std::string>, Sums> stimuli;
  for (const TrialRow* trial : selection.trials) {
    for (const std::string& condition : trial->shown_in_vain)
      ++stimuli[{trial->cell, place(condition), condition}].summary.shown_again;
    for (const IntervalRow& interval : trial->intervals) {
      Sums& sums = stimuli[{trial->cell, place(interval.condition), interval.condition}];
      ++sums.summary.intervals;
      sums.presses.add(interval.n_presses);
      sums.exploration.add(interval.exploration_time_s);
      sums.force.add(interval.peak_force_n);
      sums.depth.add(interval.max_depth_m);
      keep_largest(sums.summary.worst_clamped_fraction, interval.clamped_fraction);
      keep_largest(sums.summary.worst_loop_p999_ms, interval.loop_p999_ms);
      keep_largest(sums.summary.worst_force_error_bound_n, interval.force_error_bound_n);
      count(sums.summary.missed_cycles, interval.missed_cycles);
      count(sums.summary.cycles_within_tolerance, interval.cycles_within_tolerance);
      count(sums.summary.cycles_at_cap, interval.cycles_at_cap);
    }
  }
  std::vector<StimulusSummary> summaries;
  for (auto& [key, sums] : stimuli) {
    sums.summary.cell = design.cells[std::get<0>(key)].name;
    sums.summary.condition = std::get<2>(key);
    sums.summary.mean_presses = sums.presses.value().value_or(0.0);
    sums.summary.mean_exploration_s = sums.exploration.value();
    sums.summary.mean_peak_force_n = sums.force.value();
    sums.summary.mean_max_depth_m = sums.depth.value();
    summaries.push_back(sums.summary);
  }
  return summaries;
}

}  // namespace palpate::analysis
