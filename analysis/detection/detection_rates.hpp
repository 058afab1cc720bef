#pragma once

#include <functional>

#include "analysis/detection/detection.hpp"

namespace palpate::analysis {

/// Probabilities of the four outcomes; complements are kept apart, so that tails keep their digits.
struct DetectionRates {
  double hit = 0.0, miss = 0.0;
  double false_alarm = 0.0, rejection = 0.0;
};

/// What an observer with a sensitivity and a criterion does.
using DetectionModel = std::function<DetectionRates(double d_prime, double criterion)>;

DetectionRates yes_no_rates(double d_prime, double criterion);
DetectionRates differencing_rates(double d_prime, double criterion);
DetectionRates independent_observation_rates(double d_prime, double criterion);

/// The d' that the likelihood ratio test does not reject, the criterion being whatever suits each best: those
/// whose deviance is below the chi-squared quantile of `level` (one degree of freedom). `lowest` is the
/// smallest d' that the model knows (−infinity where it has no bound), `best` the d' of the uncorrected
/// counts. Source: [VenzonMoolgavkar1988].
Interval profile_interval(const DetectionCounts& counts, const DetectionModel& model, double best,
                          double lowest, double level);

}  // namespace palpate::analysis
