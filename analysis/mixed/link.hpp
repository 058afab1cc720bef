#pragma once

#include <cmath>
#include <numbers>
#include <string_view>

namespace palpate::analysis {

// Probability as a function of the linear predictor eta, for answers of two kinds.

enum class Link { Logit, Probit };

/// "logit" or "probit"; anything else is a std::invalid_argument that lists the two.
Link link_from_name(std::string_view name);
std::string_view name_of(Link link);

/// eta at which the probability is p, 0 < p < 1.
double quantile_of(Link link, double p);

/// log of the probability of `ones` ones among `trials` answers in a given order, and its derivatives to eta.
/// The curvature is the observed one (not its expectation), never negative: both links are log-concave.
struct BinaryLikelihood {
  double log = 0.0;
  double score = 0.0;            // d log/d eta
  double curvature = 0.0;        // w = -d2 log/d eta2
  double curvature_slope = 0.0;  // dw/d eta
};

inline BinaryLikelihood logit_likelihood(double eta, double ones, double trials) {
  const double e = std::exp(-std::abs(eta)), tail = e / (1 + e);  // the smaller of the two probabilities
  const double p = eta > 0 ? 1 - tail : tail;
  const double v = trials * tail * (1 - tail);
  const double log_larger = -std::log1p(e), log_smaller = log_larger - std::abs(eta);
  return {.log = ones * (eta > 0 ? log_larger : log_smaller) +
                 (trials - ones) * (eta > 0 ? log_smaller : log_larger),
          .score = ones - trials * p,
          .curvature = v,
          .curvature_slope = v * (1 - 2 * p)};
}

/// log Phi(s) and the inverse Mills ratio phi(s)/Phi(s), without underflow.
struct NormalTail {
  double log = 0.0;
  double ratio = 0.0;
};

inline NormalTail normal_tail(double s) {
  constexpr double kLogRootTwoPi = 0.91893853320467274178;
  if (s < -35) {  // the asymptotic series; its next term is below 4e-17 of the whole
    const double i = 1 / (s * s),
                 series = 1 - i * (1 - i * (3 - i * (15 - i * (105 - i * (945 - i * 10395)))));
    return {.log = -s * s / 2 - kLogRootTwoPi - std::log(-s) + std::log(series), .ratio = -s / series};
  }
  const double tail = std::erfc(std::abs(s) / std::numbers::sqrt2) / 2;
  const double density = std::exp(-s * s / 2 - kLogRootTwoPi);
  if (s > 0) return {.log = std::log1p(-tail), .ratio = density / (1 - tail)};
  return {.log = std::log(tail), .ratio = density / tail};
}

inline BinaryLikelihood probit_likelihood(double eta, double ones, double trials) {
  BinaryLikelihood sum;
  const auto add = [&](double sign, double count) {
    if (count == 0) return;
    const double s = sign * eta;
    const auto [log, ratio] = normal_tail(s);
    const double w = ratio * (ratio + s);
    sum.log += count * log;
    sum.score += count * sign * ratio;
    sum.curvature += count * w;
    sum.curvature_slope += count * sign * (ratio - w * (2 * ratio + s));
  };
  add(1, ones);
  add(-1, trials - ones);
  return sum;
}

inline BinaryLikelihood likelihood(Link link, double eta, double ones, double trials) {
  return link == Link::Logit ? logit_likelihood(eta, ones, trials) : probit_likelihood(eta, ones, trials);
}

}  // namespace palpate::analysis
