#pragma once

#include <cstdint>
#include <functional>
#include <span>

#include "analysis/numerics/result.hpp"

namespace palpate::analysis {

struct BootstrapOptions {
  double level = 0.95;
  long resamples = 9999;
  std::uint64_t seed = 1;
};

/// Percentile interval of a statistic of n examinees: they are drawn anew with replacement, `statistic` gets
/// their indices, and the interval ends at the order statistics (resamples + 1)(1 ∓ level)/2 of what it
/// returns. Source: [EfronTibshirani1993] ch. 13. Throws std::invalid_argument for fewer than 999 resamples
/// or a level that is none.
Interval bootstrap_interval(std::size_t n,
                            const std::function<double(std::span<const std::size_t>)>& statistic,
                            const BootstrapOptions& options);

}  // namespace palpate::analysis
