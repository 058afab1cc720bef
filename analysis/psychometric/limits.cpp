#include "analysis/psychometric/limits.hpp"

#include <algorithm>

#include "analysis/numerics/infinity.hpp"
#include "analysis/psychometric/likelihood.hpp"

namespace palpate::analysis {
namespace {

struct Counts {
  double correct = 0.0, trials = 0.0;
};

// The rows of a design from one row on, before another.
Counts between(const Design& design, std::span<const double> correct, std::size_t first, std::size_t end) {
  Counts sum;
  for (std::size_t row = first; row < end; ++row) {
    sum.correct += correct[row];
    sum.trials += design.trials[row];
  }
  return sum;
}

double best_lapse(const PsychometricModel& model, const Counts& above) {
  if (above.trials == 0) return model.lapse_lower;
  return std::clamp(1 - above.correct / above.trials, model.lapse_lower, model.lapse_upper);
}

double log_at(const Counts& counts, double p) {
  return log_binomial(counts.correct, counts.trials, p, 1 - p);
}

}  // namespace

StepLimit best_step(const Design& design, std::span<const double> correct) {
  const PsychometricModel& model = design.model;
  const std::size_t groups = design.group.size() - 1, rows = correct.size();
  StepLimit best{.log_likelihood = -kInfinity};
  for (std::size_t i = 0; i < groups; ++i) {
    const std::size_t first = design.group[i], end = design.group[i + 1];
    const double below = log_at(between(design, correct, 0, first), model.guess);
    const Counts here = between(design, correct, first, end), above = between(design, correct, end, rows);
    if (i > 0) {  // the step stands between this level and the one before
      const Counts upper = between(design, correct, first, rows);
      const double lapse = best_lapse(model, upper);
      const double value = below + log_at(upper, 1 - lapse);
      if (value > best.log_likelihood)
        best = {value, design.place[first - 1], design.place[first], 0.0, lapse};
    }
    const double lapse = best_lapse(model, above);
    const double p = std::clamp(here.correct / here.trials, model.guess, 1 - lapse);
    const double value = below + log_at(here, p) + log_at(above, 1 - lapse);
    const bool between_both = p > model.guess && p < 1 - lapse;  // else it stands beside this level
    if (between_both && value > best.log_likelihood)
      best = {value, design.place[first], design.place[first], p, lapse};
  }
  return best;
}

FlatLimit best_flat(const Design& design, std::span<const double> correct) {
  const Counts all = between(design, correct, 0, correct.size());
  const double p = std::clamp(all.correct / all.trials, design.model.guess, 1 - design.model.lapse_lower);
  return {.log_likelihood = log_at(all, p), .probability = p};
}

}  // namespace palpate::analysis
