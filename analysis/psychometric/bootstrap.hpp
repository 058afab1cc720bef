#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string_view>
#include <vector>

#include "analysis/numerics/result.hpp"
#include "analysis/psychometric/fit.hpp"

namespace palpate::analysis {

/// Where replicates come from.
enum class Bootstrap {
  Parametric,    // binomial numbers with the probabilities of the fitted function
  NonParametric  // with the proportions observed at each block
};

/// "parametric" or "nonparametric"; anything else is a std::invalid_argument.
Bootstrap bootstrap_from_name(std::string_view name);
std::string_view name_of(Bootstrap kind);

/// A refit of one replicate: alpha and beta as in PsychometricFit (beta infinite for a step; 0 and alpha,
/// lapse NaN where flat).
struct Replicate {
  double alpha = 0.0;
  double beta = 0.0;
  double lapse = 0.0;
  double deviance = 0.0;
};

/// Which replicates of a bootstrap: `first` up to, not including, `end`.
struct Share {
  long first = 0;
  long end = 0;
};

/// The K-th of N contiguous shares, K = 1 to N, that differ in length by one at most.
Share share_of(long replicates, long k, long n);

/// The replicates of a share. Each draws from a stream of its own, which the seed and its number alone
/// determine [SteeleLeaFlood2014]: shares computed anywhere, in any order, are the whole. One binomial number
/// a block, by inversion of its distribution. Source of the method: [WichmannHill2001b].
std::vector<Replicate> bootstrap_replicates(const Fitter& fitter, std::span<const double> probabilities,
                                            std::uint64_t seed, Share share);

/// Percentile interval of a measure over the replicates: order statistics at (R + 1)(1 -+ level)/2, linear
/// between neighbours. A replicate whose measure is NaN counts as lowest for the lower end and as highest for
/// the upper one. Infinite where there are too few replicates for the level.
Interval percentile_interval(std::span<const Replicate> replicates,
                             const std::function<double(const Replicate&)>& measure, double level);

/// (1 + number of deviances at least as great)/(1 + replicates): never 0 [PhipsonSmyth2010].
double deviance_p(std::span<const Replicate> replicates, double deviance);

}  // namespace palpate::analysis
