#include "analysis/psychometric/bootstrap.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <boost/math/distributions/binomial.hpp>
#include <cmath>
#include <stdexcept>

#include "analysis/numerics/infinity.hpp"
#include "analysis/psychometric/goodness.hpp"

namespace palpate::analysis {
namespace {

std::uint64_t mixed(std::uint64_t z) {  // the output function of SplitMix64
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
  return z ^ (z >> 31);
}

// The random numbers of one replicate.
class Stream {
 public:
  Stream(std::uint64_t seed, long replicate)
      : state_(mixed(mixed(seed + kGolden) + kGolden * static_cast<std::uint64_t>(replicate))) {}
  double uniform() { return static_cast<double>(mixed(state_ += kGolden) >> 11) * 0x1.0p-53; }  // [0, 1)

 private:
  static constexpr std::uint64_t kGolden = 0x9e3779b97f4a7c15ULL;
  std::uint64_t state_;
};

// P(X <= 0), ..., P(X <= n - 1) of a binomial number.
std::vector<double> cumulative(double trials, double p) {
  const boost::math::binomial_distribution<> distribution(trials, std::clamp(p, 0.0, 1.0));
  const auto most = static_cast<std::size_t>(trials);
  std::vector<double> below(most);
  for (std::size_t k = 0; k < most; ++k) below[k] = cdf(distribution, static_cast<double>(k));
  return below;
}

double drawn(const std::vector<double>& below, double uniform) {
  return static_cast<double>(std::ranges::upper_bound(below, uniform) - below.begin());
}

// Linear between the order statistics about place 1 ... size.
double order_statistic(const std::vector<double>& sorted, double place) {
  const auto below = static_cast<std::size_t>(place);
  const double share = place - std::floor(place);
  const double low = sorted[below - 1];
  if (share == 0 || below >= sorted.size()) return low;
  const double high = sorted[below];
  return low == high || std::isinf(low) ? low : low + share * (high - low);
}

}  // namespace

Bootstrap bootstrap_from_name(std::string_view name) {
  if (name == "parametric") return Bootstrap::Parametric;
  if (name == "nonparametric") return Bootstrap::NonParametric;
  throw std::invalid_argument(fmt::format("bootstrap is '{}'; accepted: parametric, nonparametric", name));
}

std::string_view name_of(Bootstrap kind) {
  return kind == Bootstrap::Parametric ? "parametric" : "nonparametric";
}

Share share_of(long replicates, long k, long n) {
  const auto end = [&](long part) {  // floor(replicates part/n), without a product that may overflow
    return replicates / n * part + replicates % n * part / n;
  };
  return {.first = end(k - 1), .end = end(k)};
}

std::vector<Replicate> bootstrap_replicates(const Fitter& fitter, std::span<const double> probabilities,
                                            std::uint64_t seed, Share share) {
  const Design& design = fitter.design();
  std::vector<std::vector<double>> below;
  for (std::size_t row = 0; row < probabilities.size(); ++row)
    below.push_back(cumulative(design.trials[row], probabilities[row]));
  std::vector<Replicate> replicates;
  replicates.reserve(std::max(0L, share.end - share.first));
  std::vector<double> correct(probabilities.size());
  for (long number = share.first; number < share.end; ++number) {
    Stream stream(seed, number);
    for (std::size_t row = 0; row < correct.size(); ++row) correct[row] = drawn(below[row], stream.uniform());
    const PsychometricFit fit = fitter.fit(correct);
    replicates.push_back({.alpha = fit.alpha,
                          .beta = fit.beta,
                          .lapse = fit.lapse,
                          .deviance = deviance_of(design, correct, fit.log_likelihood)});
  }
  return replicates;
}

Interval percentile_interval(std::span<const Replicate> replicates,
                             const std::function<double(const Replicate&)>& measure, double level) {
  require_level(level, "confidence level");
  std::vector<double> low, high;
  for (const Replicate& replicate : replicates) {
    const double value = measure(replicate);
    low.push_back(std::isnan(value) ? -kInfinity : value);
    high.push_back(std::isnan(value) ? kInfinity : value);
  }
  std::ranges::sort(low);
  std::ranges::sort(high);
  Interval interval{
      .lower = -kInfinity, .upper = kInfinity, .level = level, .method = "bootstrap percentile"};
  const double count = static_cast<double>(low.size());
  double tail = (count + 1) * (1 - level) / 2;
  if (std::abs(tail - std::round(tail)) < 1e-9) tail = std::round(tail);  // 10 x 0.2/2 is meant to be 1
  if (tail < 1) return interval;
  interval.lower = order_statistic(low, tail);
  interval.upper = order_statistic(high, count + 1 - tail);
  return interval;
}

double deviance_p(std::span<const Replicate> replicates, double deviance) {
  const double slack = 1e-9 * (1 + deviance);  // equal answers give equal deviances but for round-off
  const auto as_great = std::ranges::count_if(
      replicates, [&](const Replicate& replicate) { return replicate.deviance >= deviance - slack; });
  return static_cast<double>(1 + as_great) / static_cast<double>(1 + replicates.size());
}

}  // namespace palpate::analysis
