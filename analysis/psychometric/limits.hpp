#pragma once

#include <span>

#include "analysis/psychometric/design.hpp"

namespace palpate::analysis {

// The likelihood of a psychometric function may have its supremum where no function of the family is: at an
// infinite slope or at a slope of zero. Both limits have closed forms, so that it can be told for certain
// whether a maximum exists.

/// The best function of infinite slope: guess below the step, 1 - lapse above. Where the step stands at a
/// level itself, that level's probability is free between the two.
struct StepLimit {
  double log_likelihood = 0.0;
  double lower = 0.0, upper = 0.0;  // the step stands between these u; equal: at a level
  double probability = 0.0;         // at that level, if it stands at one
  double lapse = 0.0;
};
StepLimit best_step(const Design& design, std::span<const double> correct);

/// The best function that does not rise: one probability at all levels.
struct FlatLimit {
  double log_likelihood = 0.0;
  double probability = 0.0;
};
FlatLimit best_flat(const Design& design, std::span<const double> correct);

}  // namespace palpate::analysis
