#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>

#include "base/text/enum_words.hpp"
#include "trials/adaptive/adaptive.hpp"
#include "trials/adaptive/level_reader.hpp"

namespace palpate::trials {

/// What a step adds to: the level itself, its decimal logarithm, or its decibels, 20 log10 of the level.
enum class StepType { Linear, Log10, Decibel };
inline constexpr base::EnumWords<StepType, 3> kStepTypeWords{
    {{StepType::Linear, "linear", "to the level"},
     {StepType::Log10, "log10", "to log10 of the level"},
     {StepType::Decibel, "dB", "to 20 log10 of the level"}}};

/// Levels that go up and down by steps between two limits: what staircases share.
struct LevelSteps {
  double start = 0.0;
  StepType type = StepType::Linear;
  double min = 0.0, max = 0.0;  // infinite: no limit
};

// The keys of LevelSteps.
inline constexpr base::Key kStartKey{.name = "start",
                                     .takes = kLevel,
                                     .example = "\"5.0 MPa\"",
                                     .meaning = "The level of the first question."};
inline constexpr base::Key kStepTypeKey{
    .name = "step_type",
    .takes = base::takes_word(base::words_of<kStepTypeWords>),
    .fallback = "\"linear\"",
    .meaning =
        "What a step is added to. Steps of log10 and dB are numbers without a unit, and levels above 0."};
inline constexpr base::Key kMinKey{.name = "min",
                                   .takes = kLevel,
                                   .example = "\"0.5 MPa\"",
                                   .absent = "no limit",
                                   .meaning = "The lowest level. A step that would pass it ends on it."};
inline constexpr base::Key kMaxKey{.name = "max",
                                   .takes = kLevel,
                                   .example = "\"20 MPa\"",
                                   .absent = "no limit",
                                   .meaning = "The highest level. A step that would pass it ends on it."};

/// start, step_type, min and max.
LevelSteps read_level_steps(LevelReader& procedure);

/// Steps > 0: levels where they are linear, else numbers.
std::vector<double> read_steps(LevelReader& procedure, std::string_view key, StepType type);

/// What a key of one step size takes.
inline constexpr base::Takes kStepSize = base::takes_other(
    "a number, or a quantity with its unit such as \"0.5 MPa\" where steps are linear and levels are "
    "quantities");
/// One such step.
double read_step(LevelReader& procedure, std::string_view key, StepType type);

/// The level one step on, within the limits.
/// @param step  signed: linear in the level's unit, else in log10 or dB
double stepped(const LevelSteps& steps, double level, double step);

/// The memory of a run of steps: where it is and where it was going.
enum StepMemory : std::size_t {
  kAtLevel,
  kDirection,
  kStepMemorySize
};  // direction: 0 at first, then -1 or 1

/// Notes the direction (-1 or 1) of the step after an answer, and a reversal at the level that was shown
/// where it is another than before. Whether it was one.
bool turn(AdaptiveRun& run, const AdaptiveAnswer& answer, double direction);

/// Arithmetic for linear steps, geometric for the others: the mean on the scale on which steps are alike.
/// Nothing without reversals.
std::optional<double> mean_of_levels(StepType type, std::span<const Reversal> reversals);

}  // namespace palpate::trials
