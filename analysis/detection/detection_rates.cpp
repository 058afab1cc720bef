#include "analysis/detection/detection_rates.hpp"

#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/tools/minima.hpp>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <numbers>

#include "analysis/numerics/infinity.hpp"
#include "analysis/numerics/standard_normal.hpp"

namespace palpate::analysis {
namespace {

constexpr double kFar = 30.0;  // a d' beyond what any number of answers can tell from certainty

double term(long count, double probability) {  // 0 log 0 = 0, and no infinity that would stop the search
  return count == 0 ? 0.0 : static_cast<double>(count) * std::log(std::max(probability, 1e-300));
}

double log_likelihood(const DetectionCounts& counts, const DetectionRates& rates) {
  return term(counts.hits, rates.hit) + term(counts.signal_trials - counts.hits, rates.miss) +
         term(counts.false_alarms, rates.false_alarm) +
         term(counts.noise_trials - counts.false_alarms, rates.rejection);
}

double best_log_likelihood(const DetectionCounts& counts, const DetectionModel& model, double d_prime) {
  const double reach = 9 + std::abs(d_prime);
  const auto loss = [&](double criterion) { return -log_likelihood(counts, model(d_prime, criterion)); };
  return -boost::math::tools::brent_find_minima(loss, -reach, reach, 40).second;
}

}  // namespace

DetectionRates yes_no_rates(double d_prime, double criterion) {
  const double hit = d_prime / 2 - criterion, alarm = -d_prime / 2 - criterion;
  return {.hit = Phi(hit), .miss = Phi(-hit), .false_alarm = Phi(alarm), .rejection = Phi(-alarm)};
}

DetectionRates differencing_rates(double d_prime, double criterion) {
  const double k = std::max(0.0, criterion) / std::numbers::sqrt2, d = d_prime / std::numbers::sqrt2;
  return {.hit = Phi(d - k) + Phi(-d - k),
          .miss = Phi(k - d) - Phi(-k - d),
          .false_alarm = 2 * Phi(-k),
          .rejection = Phi(k) - Phi(-k)};
}

DetectionRates independent_observation_rates(double d_prime, double criterion) {
  const double up = Phi(d_prime / 2), down = Phi(-d_prime / 2);
  const double wrong = 2 * up * down;  // 1 - up^2 - down^2, with all its digits
  const boost::math::normal normal;
  return yes_no_rates(wrong > 0 ? -2 * quantile(normal, wrong) : 2 * kFar, criterion);
}

Interval profile_interval(const DetectionCounts& counts, const DetectionModel& model, double best,
                          double lowest, double level) {
  const double limit = quantile(boost::math::chi_squared(1), level);
  const double from = std::max(lowest, -kFar);
  const double peak = std::isnan(best) ? std::max(from, 0.0) : std::clamp(best, from, kFar);
  const double top = best_log_likelihood(counts, model, peak);
  const auto excess = [&](double d) { return 2 * (top - best_log_likelihood(counts, model, d)) - limit; };
  const auto root = [&](double lower, double upper) {
    std::uintmax_t steps = 200;
    const auto found = boost::math::tools::toms748_solve(
        excess, lower, upper, boost::math::tools::eps_tolerance<double>(40), steps);
    return (found.first + found.second) / 2;
  };
  return {.lower = excess(from) > 0 ? root(from, peak) : lowest,
          .upper = excess(kFar) > 0 ? root(peak, kFar) : kInfinity,
          .level = level,
          .method = "profile likelihood"};
}

}  // namespace palpate::analysis
