#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "app/commands/procedure/replayed_output.hpp"

namespace palpate::app {
namespace {

PlotSeries levels_over_trials(const ReplayedRun& run) {
  PlotSeries series{.name = "level"};
  for (const ReplayedTrial& trial : run.trials) {
    series.x.push_back(static_cast<double>(series.x.size() + 1));
    series.y.push_back(trial.level);
  }
  return series;
}

/// The levels of some trials as marks, with a gap after each.
template <class Belongs>
PlotSeries marks_where(const std::string& name, const ReplayedRun& run, Belongs belongs) {
  PlotSeries series{.name = name};
  for (std::size_t i = 0; i < run.trials.size(); ++i) {
    if (!belongs(i)) continue;
    series.x.insert(series.x.end(), 2, static_cast<double>(i + 1));
    series.y.insert(series.y.end(), {run.trials[i].level, NAN});
  }
  return series;
}

PlotSeries threshold_of(const ReplayedRun& run) {
  PlotSeries series{.name = "threshold, mean and sd"};
  for (std::size_t i = 0; i < run.trials.size(); ++i) {
    const trials::ParameterBelief& threshold = run.trials[i].belief->parameters.front();
    series.x.push_back(static_cast<double>(i + 1));
    series.y.push_back(threshold.mean - threshold.sd);
    series.high.push_back(threshold.mean + threshold.sd);
  }
  return series;
}

}  // namespace

Plot run_plot(const trials::LoadedProcedure& loaded, const ReplayedRun& run) {
  if (run.trials.empty()) throw std::invalid_argument("--plot: no trials to draw; accepted: with --answers");
  PlotPanel panel{.series = {levels_over_trials(run)}};
  if (run.trials.front().belief) panel.series.push_back(threshold_of(run));
  if (std::ranges::any_of(run.trials, [](const ReplayedTrial& trial) { return !trial.correct; }))
    panel.series.push_back(
        marks_where("wrong answer", run, [&](std::size_t i) { return !run.trials[i].correct; }));
  if (!run.reversals.empty()) {
    std::vector<bool> turns(run.trials.size());
    for (const trials::Reversal& reversal : run.reversals)
      turns[static_cast<std::size_t>(reversal.trial) - 1] = true;
    panel.series.push_back(marks_where("reversal", run, [&](std::size_t i) { return turns[i]; }));
  }
  return {.title = std::string(loaded.procedure->name),
          .note = std::string(loaded.procedure->meaning),
          .x_label = "trial",
          .y_label = fmt::format("{}{}", loaded.level.empty() ? "level" : loaded.level,
                                 loaded.scale.unit ? fmt::format(" [{}]", loaded.scale.unit->name) : ""),
          .panels = {panel}};
}

}  // namespace palpate::app
