#pragma once

#include "analysis/detection/choice_task.hpp"
#include "analysis/detection/dprime.hpp"
#include "analysis/numerics/result.hpp"

namespace palpate::analysis {

/// Answers "yes" (or "different") to trials that held the signal (or a difference) and to trials that did
/// not.
struct DetectionCounts {
  long hits = 0, signal_trials = 0;
  long false_alarms = 0, noise_trials = 0;
};

struct Detection {
  DetectionCounts counts{};
  DPrimeCorrection correction = DPrimeCorrection::LogLinear;
  double hit_rate = 0.0, false_alarm_rate = 0.0;  // that entered the model, corrected
  bool corrected = false;                         // whether the correction changed either
  double d_prime = 0.0;
  double standard_error = 0.0;  // by the delta method; infinite where there is none
  Interval interval{};          // profile likelihood of the uncorrected counts; ends may be infinite
  double criterion = 0.0;       // see the functions
  Method method{};
};

/// Yes/no: one observation a trial, N(0, 1) or N(d', 1). d' = z(H) − z(F); criterion c = −(z(H) + z(F))/2,
/// below 0 where "yes" is favoured; its standard error is half that of d'. Sources: [MacmillanCreelman2005]
/// ch. 1 and 2; standard error [GourevitchGalanter1967]. Throws std::invalid_argument for counts that cannot
/// be.
Detection yes_no(const DetectionCounts& counts, DPrimeCorrection correction, double level = 0.95);

/// Same-different: two observations a trial, "different" answered by one of two strategies
/// [MacmillanCreelman2005] ch. 9.
/// Differencing: when they lie further apart than the criterion k: F = 2 Φ(−k/√2), H = Φ((d' − k)/√2) +
/// Φ((−d' − k)/√2).
/// Independent observations: when each is judged against the boundary between the two stimuli and the
/// judgements differ, or, off the neutral criterion, by the likelihood ratio, whose ROC is taken for that of
/// two normal distributions of one variance, as the published tables do: Φ((z(H) − z(F))/2) = Φ(d'/2)² +
/// Φ(−d'/2)²; criterion c = −(z(H) + z(F))/2. d' is never negative: it is 0 where hits are no more frequent
/// than false alarms, without a standard error. Throws std::invalid_argument for counts that cannot be.
Detection same_different(const DetectionCounts& counts, Strategy strategy, DPrimeCorrection correction,
                         double level = 0.95);

}  // namespace palpate::analysis
