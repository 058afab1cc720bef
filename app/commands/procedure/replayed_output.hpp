#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "app/command_line/plot.hpp"
#include "app/commands/procedure/replayed_run.hpp"

namespace palpate::app {

nlohmann::ordered_json run_as_json(const trials::LoadedProcedure& loaded, const ReplayedRun& run);
std::string run_as_text(const trials::LoadedProcedure& loaded, const ReplayedRun& run);
/// A row for each trial.
std::string run_as_csv(const trials::LoadedProcedure& loaded, const ReplayedRun& run);
/// Levels over trials, with wrong answers, reversals, and what a Bayesian procedure takes the threshold for.
Plot run_plot(const trials::LoadedProcedure& loaded, const ReplayedRun& run);

}  // namespace palpate::app
