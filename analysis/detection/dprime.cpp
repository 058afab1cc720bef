#include "analysis/detection/dprime.hpp"

#include <fmt/core.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "analysis/detection/detection.hpp"
#include "analysis/numerics/infinity.hpp"
#include "analysis/numerics/proportion_interval.hpp"

namespace palpate::analysis {
namespace {

// The delta method: the binomial standard error of the proportion over the slope of the task's function.
double standard_error_of(const DPrime& result) {
  const double slope = std::isinf(result.d_prime) ? 0.0 : slope_at(result.task, result.d_prime);
  if (slope <= 0) return kInfinity;
  const double p = result.proportion;
  return std::sqrt(p * (1 - p) / static_cast<double>(result.trials)) / slope;
}

Interval interval_of(const ChoiceTask& task, long correct, long trials, double level) {
  const Interval exact = clopper_pearson(correct, trials, level);
  const bool two = knows_direction(task) && task.alternatives == 2;
  Interval interval{.lower = d_prime_at(task, exact.lower),
                    .upper = d_prime_at(task, exact.upper),
                    .level = level,
                    .method = two ? "sqrt(2) z of the Clopper-Pearson interval"
                                  : "d' at the ends of the Clopper-Pearson interval"};
  if (!knows_direction(task) && exact.upper < chance_of(task)) {
    interval.lower = interval.upper = std::numeric_limits<double>::quiet_NaN();
    interval.method = "the whole interval of the proportion lies below chance";
  }
  return interval;
}

Method method_of(const ChoiceTask& task) {
  const std::string strategy = task.strategy ? fmt::format(", {} strategy", name_of(*task.strategy)) : "";
  switch (task.kind) {
    case ChoiceKind::TwoInterval:
      return {"d' of a two-interval forced choice, sqrt(2) z(proportion correct)",
              "Macmillan & Creelman 2005, ch. 7"};
    case ChoiceKind::TwoAlternative:
      return {"d' of a two-alternative forced choice, sqrt(2) z(proportion correct)",
              "Macmillan & Creelman 2005, ch. 7"};
    case ChoiceKind::Alternatives:
      return {fmt::format("d' of a forced choice among {} alternatives", task.alternatives),
              "Hacker & Ratcliff 1979"};
    case ChoiceKind::Triangle:
      return {"d' of the triangle test, the sample that differs most being named", "Ennis 1993"};
    case ChoiceKind::Oddity:
      return {"d' of a three-interval oddity task" + strategy, "Versfeld, Dai & Green 1996"};
    case ChoiceKind::Abx:
      break;
  }
  return {"d' of an ABX task" + strategy, "Macmillan & Creelman 2005, ch. 9"};
}

}  // namespace

DPrimeCorrection correction_from_name(std::string_view name) {
  if (name == "none") return DPrimeCorrection::None;
  if (name == "half-trial") return DPrimeCorrection::HalfTrial;
  if (name == "log-linear") return DPrimeCorrection::LogLinear;
  throw std::invalid_argument(
      fmt::format("correction is '{}'; accepted: none, half-trial, log-linear", name));
}

std::string_view name_of(DPrimeCorrection correction) {
  switch (correction) {
    case DPrimeCorrection::None:
      return "none";
    case DPrimeCorrection::HalfTrial:
      return "half-trial";
    case DPrimeCorrection::LogLinear:
      break;
  }
  return "log-linear";
}

std::string source_of(DPrimeCorrection correction) {
  switch (correction) {
    case DPrimeCorrection::None:
      break;
    case DPrimeCorrection::HalfTrial:
      return "; at 0 and 100 % corrected by 1/(2n), Macmillan & Kaplan 1985";
    case DPrimeCorrection::LogLinear:
      return "; log-linear correction (k + 1/2)/(n + 1), Hautus 1995";
  }
  return "; without correction";
}

double corrected_proportion(long correct, long trials, DPrimeCorrection correction) {
  require_counts(correct, trials);
  const double k = static_cast<double>(correct), n = static_cast<double>(trials);
  if (correction == DPrimeCorrection::LogLinear) return (k + 0.5) / (n + 1);
  if (correction == DPrimeCorrection::HalfTrial && correct == 0) return 0.5 / n;
  if (correction == DPrimeCorrection::HalfTrial && correct == trials) return 1 - 0.5 / n;
  return k / n;
}

DPrime dprime(const ChoiceTask& task, long correct, long trials, DPrimeCorrection correction, double level) {
  DPrime result{.task = task, .correct = correct, .trials = trials, .correction = correction};
  result.proportion = corrected_proportion(correct, trials, correction);
  result.corrected = result.proportion != corrected_proportion(correct, trials, DPrimeCorrection::None);
  result.d_prime = d_prime_at(task, result.proportion);
  result.standard_error = standard_error_of(result);
  result.interval = interval_of(task, correct, trials, level);
  result.method = method_of(task);
  result.method.source += source_of(correction);
  return result;
}

DPrime dprime_2ifc(long correct, long trials, DPrimeCorrection correction, double level) {
  return dprime({}, correct, trials, correction, level);
}

// With the first interval's trials for signal and the answer "first" for "yes" it is a yes/no task whose d'
// is sqrt(2) times as large.
DPrimeByOrder dprime_2ifc_by_order(long correct_first, long trials_first, long correct_second,
                                   long trials_second, DPrimeCorrection correction, double level) {
  const Detection as_yes_no = yes_no({.hits = correct_first,
                                      .signal_trials = trials_first,
                                      .false_alarms = trials_second - correct_second,
                                      .noise_trials = trials_second},
                                     correction, level);
  DPrimeByOrder result{.correction = correction};
  result.corrected = as_yes_no.corrected;
  result.d_prime = as_yes_no.d_prime / std::numbers::sqrt2;
  result.standard_error = as_yes_no.standard_error / std::numbers::sqrt2;
  result.interval = as_yes_no.interval;
  result.interval.lower /= std::numbers::sqrt2;
  result.interval.upper /= std::numbers::sqrt2;
  result.criterion = as_yes_no.criterion;
  result.method = {.name = "d' of a two-interval forced choice from the hit rates of both orders",
                   .source = "Macmillan & Creelman 2005, ch. 7" + source_of(correction)};
  return result;
}

}  // namespace palpate::analysis
