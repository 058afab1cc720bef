#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/binomial/binomial_power.hpp"

namespace palpate::analysis {

struct PowerAsked {
  double chance = 0.5, probability = 0.75, alpha = 0.05, target = 0.8;
  Side side = Side::Greater;
  long each = 1;                // answers of one examinee: sizes are its multiples
  double overdispersion = 0.0;  // of examinees; see beta_binomial_counts()
};

/// Exact power of the pooled binomial test at every size up to a largest one: a sawtooth.
struct PowerCurve {
  std::vector<long> trials{};  // each, 2 each, ...
  std::vector<double> power{};
  SampleSize size{};                   // the first size with the target, and the one from which it lasts
  std::optional<std::string> never{};  // why no size has the target, however large
};

/// Throws std::invalid_argument unless the numbers are probabilities, 0 <= overdispersion < 1, each >= 1, and
/// each <= largest <= 20000.
PowerCurve power_curve(const PowerAsked& asked, long largest);

}  // namespace palpate::analysis
