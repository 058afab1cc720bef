#pragma once

#include <functional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "trials/adaptive/load_adaptive.hpp"

namespace palpate::trials::test {

/// The levels that a procedure asks for, one for each answer, and where that leaves it.
struct PlayedRun {
  std::vector<double> levels{};
  AdaptiveRun run{};
};

/// @param answers  "1101": 1 correct, 0 wrong
inline PlayedRun play(const LoadedProcedure& loaded, std::string_view answers) {
  PlayedRun played{.run = begin_adaptive(*loaded.procedure, *loaded.design)};
  for (const char answer : answers) {
    played.levels.push_back(next_level(*loaded.procedure, *loaded.design, played.run).value());
    tell_adaptive(*loaded.procedure, *loaded.design, played.run,
                  {.level = played.levels.back(), .correct = answer == '1'});
  }
  return played;
}

/// Lets someone answer, who is right with a probability that follows from the level, up to the end or so many
/// trials.
/// @param is_correct  (level) -> the answer
inline PlayedRun play_observer(const LoadedProcedure& loaded, int trials,
                               const std::function<bool(double)>& is_correct) {
  PlayedRun played{.run = begin_adaptive(*loaded.procedure, *loaded.design)};
  while (played.run.told < trials) {
    const auto level = next_level(*loaded.procedure, *loaded.design, played.run);
    if (!level) break;
    played.levels.push_back(*level);
    tell_adaptive(*loaded.procedure, *loaded.design, played.run,
                  {.level = *level, .correct = is_correct(*level)});
  }
  return played;
}

/// @param keys  the lines of a [procedure] table
inline LoadedProcedure procedure_of(const std::string& keys) {
  return parse_adaptive("[procedure]\n" + keys, "p.toml");
}

/// What is said of a table that is refused; empty for one that is not.
inline std::string refusal_of_procedure(const std::string& keys) {
  try {
    procedure_of(keys);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

/// Trials and levels of reversals apart, for comparison with published lists.
inline std::vector<int> trials_of(const std::vector<Reversal>& reversals) {
  std::vector<int> trials;
  for (const Reversal& reversal : reversals) trials.push_back(reversal.trial);
  return trials;
}

}  // namespace palpate::trials::test
