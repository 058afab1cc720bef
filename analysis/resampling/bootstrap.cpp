#include "analysis/resampling/bootstrap.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <boost/random/uniform_int_distribution.hpp>
#include <cmath>
#include <random>
#include <stdexcept>
#include <vector>

namespace palpate::analysis {

Interval bootstrap_interval(std::size_t n,
                            const std::function<double(std::span<const std::size_t>)>& statistic,
                            const BootstrapOptions& options) {
  require_level(options.level, "confidence level");
  if (options.resamples < 999) {
    throw std::invalid_argument(fmt::format("{} resamples; at least 999 are needed", options.resamples));
  }
  std::mt19937_64 random(options.seed);
  // Boost's distribution, unlike the standard library's, draws the same everywhere.
  const boost::random::uniform_int_distribution<std::size_t> any(0, n - 1);
  std::vector<std::size_t> drawn(n);
  std::vector<double> values(options.resamples);
  for (double& value : values) {
    for (std::size_t& index : drawn) index = any(random);
    value = statistic(drawn);
  }
  std::ranges::sort(values);
  const double ends = static_cast<double>(options.resamples + 1) * (1 - options.level) / 2;
  const auto rank = static_cast<std::size_t>(std::max(1.0, std::floor(ends * (1 + 1e-12))));
  return {.lower = values[rank - 1],
          .upper = values[values.size() - rank],
          .level = options.level,
          .method = fmt::format("percentile bootstrap over examinees, {} resamples, seed {}",
                                options.resamples, options.seed)};
}

}  // namespace palpate::analysis
