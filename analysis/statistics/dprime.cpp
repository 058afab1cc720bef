#include "analysis/statistics/dprime.hpp"

#include <fmt/core.h>

#include <boost/math/distributions/normal.hpp>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "analysis/statistics/proportion_interval.hpp"

namespace palpate::analysis {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

double z(double proportion) {
  if (proportion <= 0) return -kInfinity;
  if (proportion >= 1) return kInfinity;
  return quantile(boost::math::normal(), proportion);
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

// Var z(p) = p(1 - p)/(n phi(z)^2), and d' = sqrt(2) z.
double standard_error_of(double proportion, long trials) {
  const double quantile = z(proportion);
  if (std::isinf(quantile)) return kInfinity;
  const double density = pdf(boost::math::normal(), quantile);
  return std::sqrt(2 * proportion * (1 - proportion) / static_cast<double>(trials)) / density;
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

double corrected_proportion(long correct, long trials, DPrimeCorrection correction) {
  require_counts(correct, trials);
  const double k = static_cast<double>(correct), n = static_cast<double>(trials);
  if (correction == DPrimeCorrection::LogLinear) return (k + 0.5) / (n + 1);
  if (correction == DPrimeCorrection::HalfTrial && correct == 0) return 0.5 / n;
  if (correction == DPrimeCorrection::HalfTrial && correct == trials) return 1 - 0.5 / n;
  return k / n;
}

DPrime dprime_2ifc(long correct, long trials, DPrimeCorrection correction, double level) {
  DPrime result{.correct = correct, .trials = trials, .correction = correction};
  result.proportion = corrected_proportion(correct, trials, correction);
  result.corrected = result.proportion != corrected_proportion(correct, trials, DPrimeCorrection::None);
  result.d_prime = std::numbers::sqrt2 * z(result.proportion);
  result.standard_error = standard_error_of(result.proportion, trials);
  const Interval exact = clopper_pearson(correct, trials, level);
  result.interval = {.lower = std::numbers::sqrt2 * z(exact.lower),
                     .upper = std::numbers::sqrt2 * z(exact.upper),
                     .level = level,
                     .method = "sqrt(2) z of the Clopper-Pearson interval"};
  result.method = {.name = "d' of a two-interval forced choice, sqrt(2) z(proportion correct)",
                   .source = "Macmillan & Creelman 2005, ch. 7" + source_of(correction)};
  return result;
}

DPrimeByOrder dprime_2ifc_by_order(long correct_first, long trials_first, long correct_second,
                                   long trials_second, DPrimeCorrection correction) {
  const double first = corrected_proportion(correct_first, trials_first, correction);
  const double second = corrected_proportion(correct_second, trials_second, correction);
  DPrimeByOrder result{.correction = correction};
  result.corrected = first != corrected_proportion(correct_first, trials_first, DPrimeCorrection::None) ||
                     second != corrected_proportion(correct_second, trials_second, DPrimeCorrection::None);
  result.d_prime = (z(first) + z(second)) / std::numbers::sqrt2;
  result.criterion = (z(second) - z(first)) / 2;
  result.method = {.name = "d' of a two-interval forced choice from the hit rates of both orders",
                   .source = "Macmillan & Creelman 2005, ch. 7" + source_of(correction)};
  return result;
}

}  // namespace palpate::analysis
