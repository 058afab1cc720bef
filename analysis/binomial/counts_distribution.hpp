#pragma once

#include <vector>

namespace palpate::analysis {

// Distributions of a number of correct answers: entry k is the probability of k of them.

/// Of the sum of two independent numbers.
std::vector<double> convolve(const std::vector<double>& a, const std::vector<double>& b);

/// Of `trials` guesses or answers that are right with `probability`, independently.
std::vector<double> binomial_counts(long trials, double probability);

/// Of one examinee's `trials` answers, when examinees' probabilities are beta-distributed with the mean
/// `probability` and the overdispersion gamma = 1/(a + b + 1), 0 <= gamma < 1; 0: all alike [Brockhoff2003].
std::vector<double> beta_binomial_counts(long trials, double probability, double overdispersion);

}  // namespace palpate::analysis
