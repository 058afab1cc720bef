#include "analysis/detection/detection.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <numbers>

#include "analysis/detection/detection_rates.hpp"
#include "analysis/numerics/infinity.hpp"
#include "analysis/numerics/standard_normal.hpp"

namespace palpate::analysis {
namespace {

using std::numbers::sqrt2;

double z(double proportion) {
  if (proportion <= 0) return -kInfinity;
  if (proportion >= 1) return kInfinity;
  return quantile(boost::math::normal(), proportion);
}

Detection with_rates(const DetectionCounts& counts, DPrimeCorrection correction, double level) {
  require_counts(counts.hits, counts.signal_trials);
  require_counts(counts.false_alarms, counts.noise_trials);
  require_level(level, "confidence level");
  Detection result{.counts = counts, .correction = correction};
  const auto rate = [&](long yes, long trials) {
    const double corrected = corrected_proportion(yes, trials, correction);
    result.corrected |= corrected != corrected_proportion(yes, trials, DPrimeCorrection::None);
    return corrected;
  };
  result.hit_rate = rate(counts.hits, counts.signal_trials);
  result.false_alarm_rate = rate(counts.false_alarms, counts.noise_trials);
  return result;
}

// Root of the sum of squares of each rate's standard error times the slope of d' over that rate.
double standard_error_of(const Detection& result, double slope_hit, double slope_alarm) {
  const auto variance = [](double rate, long trials) {
    return rate * (1 - rate) / static_cast<double>(trials);
  };
  const double h = result.hit_rate, f = result.false_alarm_rate;
  const double se = std::sqrt(slope_hit * slope_hit * variance(h, result.counts.signal_trials) +
                              slope_alarm * slope_alarm * variance(f, result.counts.noise_trials));
  if (!std::isfinite(se)) return kInfinity;
  return se;
}

double raw_rate(long yes, long trials) {
  return static_cast<double>(yes) / static_cast<double>(trials);
}

// d' that turns a distance k and a hit rate into each other; hit rates of 1 are beyond every d'.
double differencing_d_prime(double hit_rate, double k) {
  if (hit_rate >= 1) return kInfinity;
  const auto excess = [&](double d) { return Phi((d - k) / sqrt2) + Phi((-d - k) / sqrt2) - hit_rate; };
  if (!(excess(0.0) < 0)) return 0.0;
  std::uintmax_t steps = 200;
  const auto [lower, upper] = boost::math::tools::toms748_solve(
      excess, 0.0, k + 20, boost::math::tools::eps_tolerance<double>(50), steps);
  return (lower + upper) / 2;
}

double differencing_criterion(double false_alarm_rate) {
  return -sqrt2 * z(false_alarm_rate / 2);
}

double d_prime_by_differencing(double hit_rate, double false_alarm_rate) {
  if (hit_rate <= false_alarm_rate) return 0.0;
  if (false_alarm_rate <= 0) return kInfinity;
  return differencing_d_prime(hit_rate, differencing_criterion(false_alarm_rate));
}

double d_prime_by_independent_observations(double hit_rate, double false_alarm_rate) {
  if (hit_rate <= false_alarm_rate) return 0.0;
  const double correct = Phi((z(hit_rate) - z(false_alarm_rate)) / 2);
  return 2 * z((1 + std::sqrt(2 * correct - 1)) / 2);
}

double differencing_error(const Detection& result) {
  const double k = result.criterion, d = result.d_prime;
  const double away = phi((k - d) / sqrt2), past = phi((k + d) / sqrt2);
  const double hit_slope = sqrt2 / (away - past);  // 1/(dH/dd')
  const double k_slope = -sqrt2 / (2 * phi(z(result.false_alarm_rate / 2)));
  return standard_error_of(result, hit_slope, (away + past) / (away - past) * k_slope);
}

double independent_observations_error(const Detection& result) {
  const double zh = z(result.hit_rate), zf = z(result.false_alarm_rate);
  const double correct = Phi((zh - zf) / 2), root = std::sqrt(2 * correct - 1);
  const double over_correct = 1 / (phi(result.d_prime / 2) * root);  // dd'/dp(c)
  const double over_z = over_correct * phi((zh - zf) / 2) / 2;
  return standard_error_of(result, over_z / phi(zh), over_z / phi(zf));
}

}  // namespace

Detection yes_no(const DetectionCounts& counts, DPrimeCorrection correction, double level) {
  Detection result = with_rates(counts, correction, level);
  const double zh = z(result.hit_rate), zf = z(result.false_alarm_rate);
  result.d_prime = zh - zf;
  result.criterion = -(zh + zf) / 2;
  result.standard_error = std::isfinite(zh) && std::isfinite(zf)
                              ? standard_error_of(result, 1 / phi(zh), 1 / phi(zf))
                              : kInfinity;
  const double best =
      z(raw_rate(counts.hits, counts.signal_trials)) - z(raw_rate(counts.false_alarms, counts.noise_trials));
  result.interval = profile_interval(counts, yes_no_rates, best, -kInfinity, level);
  result.method = {
      .name = "d' and criterion of a yes/no task",
      .source = "Macmillan & Creelman 2005, ch. 1 and 2; standard error Gourevitch & Galanter 1967" +
                source_of(correction)};
  return result;
}

Detection same_different(const DetectionCounts& counts, Strategy strategy, DPrimeCorrection correction,
                         double level) {
  const bool differencing = strategy == Strategy::Differencing;
  Detection result = with_rates(counts, correction, level);
  const double h = result.hit_rate, f = result.false_alarm_rate;
  const auto d_prime = differencing ? d_prime_by_differencing : d_prime_by_independent_observations;
  result.d_prime = d_prime(h, f);
  result.criterion = differencing ? differencing_criterion(f) : -(z(h) + z(f)) / 2;
  const bool finite = result.d_prime > 0 && std::isfinite(result.d_prime);
  result.standard_error = !finite        ? kInfinity
                          : differencing ? differencing_error(result)
                                         : independent_observations_error(result);
  const double best = d_prime(raw_rate(counts.hits, counts.signal_trials),
                              raw_rate(counts.false_alarms, counts.noise_trials));
  result.interval = profile_interval(
      counts, differencing ? differencing_rates : independent_observation_rates, best, 0.0, level);
  result.method = {.name = fmt::format("d' of a same-different task, {} strategy", name_of(strategy)),
                   .source = "Macmillan & Creelman 2005, ch. 9" + source_of(correction)};
  return result;
}

}  // namespace palpate::analysis
