#include "trials/adaptive/level_steps.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace palpate::trials {
namespace {

constexpr double kDecibelsPerDecade = 20.0;
constexpr double kLargest =
    kLargestLevel;  // where no limit is set: levels stay numbers however long a run is

double on_scale(StepType type, double level) {
  if (type == StepType::Linear) return level;
  return (type == StepType::Log10 ? 1.0 : kDecibelsPerDecade) * std::log10(level);
}

double off_scale(StepType type, double value) {
  if (type == StepType::Linear) return value;
  return std::pow(10.0, type == StepType::Log10 ? value : value / kDecibelsPerDecade);
}

}  // namespace

LevelSteps read_level_steps(LevelReader& procedure) {
  LevelSteps steps{.start = procedure.level("start"),
                   .type = procedure.table().word("step_type", kStepTypeWords),
                   .min = -std::numeric_limits<double>::infinity(),
                   .max = std::numeric_limits<double>::infinity()};
  if (procedure.has("min")) steps.min = procedure.level("min");
  if (procedure.has("max")) steps.max = procedure.level("max");
  if (steps.min >= steps.max)
    procedure.refuse("min", fmt::format("found {}, and max is {}; accepted: a level below max",
                                        procedure.in_words(steps.min), procedure.in_words(steps.max)));
  if (steps.start < steps.min || steps.start > steps.max)
    procedure.refuse("start", fmt::format("found {}, accepted: a level from min {} to max {}",
                                          procedure.in_words(steps.start), procedure.in_words(steps.min),
                                          procedure.in_words(steps.max)));
  if (steps.type != StepType::Linear) {
    if (steps.start <= 0.0)
      procedure.refuse("start",
                       fmt::format("found {}, accepted with steps of {}: a level above 0",
                                   procedure.in_words(steps.start), word_of(kStepTypeWords, steps.type)));
    if (std::isfinite(steps.min) && steps.min < 0.0)
      procedure.refuse("min",
                       fmt::format("found {}, accepted with steps of {}: a level of 0 or above",
                                   procedure.in_words(steps.min), word_of(kStepTypeWords, steps.type)));
  }
  return steps;
}

std::vector<double> read_steps(LevelReader& procedure, std::string_view key, StepType type) {
  std::vector<double> steps = type == StepType::Linear ? procedure.levels(key) : procedure.numbers(key);
  for (const double step : steps)
    if (step <= 0.0)
      procedure.refuse(key,
                       fmt::format("found {:g}, accepted: steps above 0, or the level would not move", step));
  return steps;
}

double read_step(LevelReader& procedure, std::string_view key, StepType type) {
  const std::vector<double> steps = read_steps(procedure, key, type);
  if (steps.size() != 1) procedure.refuse(key, "found several steps, accepted: one");
  return steps.front();
}

double stepped(const LevelSteps& steps, double level, double step) {
  const double moved = steps.type == StepType::Linear ? level + step : level * off_scale(steps.type, step);
  const double least = steps.type == StepType::Linear ? -kLargest : 1.0 / kLargest;
  return std::clamp(moved, std::max(steps.min, least), std::min(steps.max, kLargest));
}

bool turn(AdaptiveRun& run, const AdaptiveAnswer& answer, double direction) {
  const bool turned = run.memory[kDirection] == -direction;
  if (turned) run.reversals.push_back({.trial = run.told + 1, .level = answer.level});
  run.memory[kDirection] = direction;
  return turned;
}

std::optional<double> mean_of_levels(StepType type, std::span<const Reversal> reversals) {
  if (reversals.empty()) return std::nullopt;
  double sum = 0.0;
  for (const Reversal& reversal : reversals) sum += on_scale(type, reversal.level);
  return off_scale(type, sum / static_cast<double>(reversals.size()));
}

}  // namespace palpate::trials
