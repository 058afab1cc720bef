#pragma once

#include <span>
#include <vector>

namespace palpate::analysis {

/// Distribution of the sum of those weights whose fair coin falls heads: entry s is P(sum = s), for s from 0
/// to the sum of all weights. Weights are whole numbers >= 0. It serves the sign-flip test on whole
/// differences and the signed-rank test on doubled ranks (mid-ranks are halves). Cost: number of weights x
/// their sum.
std::vector<double> sign_sum_distribution(std::span<const long> weights);

}  // namespace palpate::analysis
