#include "app/commands/procedure/replayed_output.hpp"

#include <fmt/format.h>

namespace palpate::app {
namespace {

using nlohmann::ordered_json;

ordered_json value_or_null(const std::optional<double>& value) {
  return value ? ordered_json(*value) : ordered_json();
}

/// {"threshold": .., "slope": ..} of one figure of each parameter.
ordered_json each_parameter(const trials::Belief& belief, double trials::ParameterBelief::*figure) {
  ordered_json json = ordered_json::object();
  for (const trials::ParameterBelief& parameter : belief.parameters)
    json[std::string(parameter.name)] = parameter.*figure;
  return json;
}

ordered_json trial_as_json(std::size_t number, const ReplayedTrial& trial) {
  ordered_json json{{"trial", number}, {"level", trial.level}, {"answer", trial.correct ? 1 : 0}};
  if (!trial.belief) return json;
  json["mean"] = each_parameter(*trial.belief, &trials::ParameterBelief::mean);
  json["mode"] = each_parameter(*trial.belief, &trials::ParameterBelief::mode);
  json["sd"] = each_parameter(*trial.belief, &trials::ParameterBelief::sd);
  json["expected_entropy"] = value_or_null(trial.expected_entropy);
  json["entropy"] = trial.belief->entropy;
  return json;
}

std::string trial_as_text(std::size_t number, const ReplayedTrial& trial, const trials::LevelScale& scale) {
  std::string text = fmt::format("{:5}  {:>14}  {}", number, level_in_words(trial.level, scale),
                                 trial.correct ? "correct" : "wrong  ");
  if (trial.belief) {
    for (const trials::ParameterBelief& parameter : trial.belief->parameters)
      text += fmt::format("  {} {:.4g} (mode {:.4g}, sd {:.3g})", parameter.name, parameter.mean,
                          parameter.mode, parameter.sd);
    if (trial.expected_entropy) text += fmt::format("  entropy expected {:.4f}", *trial.expected_entropy);
    text += fmt::format("  is {:.4f} bit", trial.belief->entropy);
  }
  return text + "\n";
}

}  // namespace

ordered_json run_as_json(const trials::LoadedProcedure& loaded, const ReplayedRun& run) {
  ordered_json json{{"procedure", loaded.procedure->name},
                    {"level", loaded.level.empty() ? ordered_json() : ordered_json(loaded.level)},
                    {"unit", loaded.scale.unit ? ordered_json(loaded.scale.unit->name) : ordered_json()},
                    {"trials", ordered_json::array()},
                    {"next_level", value_or_null(run.next_level)},
                    {"reversals", ordered_json::array()},
                    {"mean_of_reversals", value_or_null(run.mean_of_reversals)},
                    {"stopped_at", run.stopped_at ? ordered_json(*run.stopped_at) : ordered_json()}};
  for (std::size_t i = 0; i < run.trials.size(); ++i)
    json["trials"].push_back(trial_as_json(i + 1, run.trials[i]));
  for (const trials::Reversal& reversal : run.reversals)
    json["reversals"].push_back({{"trial", reversal.trial}, {"level", reversal.level}});
  if (loaded.procedure->estimate) json["estimate"] = value_or_null(run.estimate);
  return json;
}

std::string run_as_text(const trials::LoadedProcedure& loaded, const ReplayedRun& run) {
  const auto words = [&loaded](double level) { return level_in_words(level, loaded.scale); };
  std::string text =
      fmt::format("{}{}: {}\n", loaded.procedure->name,
                  loaded.level.empty() ? "" : fmt::format(" of {}", loaded.level), loaded.procedure->meaning);
  if (!run.trials.empty()) text += fmt::format("{:>5}  {:>14}  {}\n", "trial", "level", "answer");
  for (std::size_t i = 0; i < run.trials.size(); ++i)
    text += trial_as_text(i + 1, run.trials[i], loaded.scale);
  if (loaded.procedure->mean_of_reversals) {
    text += "reversals:";
    for (const trials::Reversal& reversal : run.reversals)
      text += fmt::format("{} trial {} at {}", &reversal == &run.reversals.front() ? "" : ",", reversal.trial,
                          words(reversal.level));
    text += run.reversals.empty() ? " none\n" : "\n";
  }
  if (run.mean_of_reversals) text += fmt::format("mean of reversals {}\n", words(*run.mean_of_reversals));
  if (run.estimate) text += fmt::format("estimate {}\n", words(*run.estimate));
  text += run.next_level ? fmt::format("next level {}\n", words(*run.next_level))
                         : fmt::format("stopped at trial {}\n", *run.stopped_at);
  return text;
}

std::string run_as_csv(const trials::LoadedProcedure& loaded, const ReplayedRun& run) {
  std::string text = loaded.scale.unit ? "trial,level,unit,answer" : "trial,level,answer";
  const bool bayesian = !run.trials.empty() && run.trials.front().belief;
  if (bayesian) {
    for (const trials::ParameterBelief& parameter : run.trials.front().belief->parameters)
      text += fmt::format(",{0}_mean,{0}_mode,{0}_sd", parameter.name);
    text += ",expected_entropy_bit,entropy_bit";
  }
  text += "\n";
  for (std::size_t i = 0; i < run.trials.size(); ++i) {
    const ReplayedTrial& trial = run.trials[i];
    text +=
        fmt::format("{},{},{}{}", i + 1, trial.level,
                    loaded.scale.unit ? loaded.scale.unit->name + "," : std::string(), trial.correct ? 1 : 0);
    if (trial.belief) {
      for (const trials::ParameterBelief& parameter : trial.belief->parameters)
        text += fmt::format(",{},{},{}", parameter.mean, parameter.mode, parameter.sd);
      text +=
          fmt::format(",{},{}", trial.expected_entropy ? fmt::format("{}", *trial.expected_entropy) : "n/a",
                      trial.belief->entropy);
    }
    text += "\n";
  }
  return text;
}

}  // namespace palpate::app
