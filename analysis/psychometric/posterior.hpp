#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "analysis/psychometric/design.hpp"

namespace palpate::analysis {

// The posterior density that bayes.hpp adds up: the priors and the likelihood of [Schuett2016].

inline constexpr std::size_t kThreshold = 0, kWidth = 1, kLapse = 2, kGuess = 3, kEta = 4, kParameters = 5;

/// Threshold and width on the scale of the design's places, lapse and guess rate, eta.
using BayesPoint = std::array<double, kParameters>;

struct BayesProblem {
  Design design{};    // its places from -1 to 1
  Placement scale{};  // on which they are so
  std::vector<double> correct{};
  bool guess_is_free = false;
  double unit_width = 0.0;  // eta from F = 0.05 to F = 0.95
  double range = 0.0;       // of the places
  double gap = 0.0;         // the least between neighbouring places
};

/// Throws std::invalid_argument as bayesian_psychometric does.
BayesProblem posed(std::span<const Block> blocks, Shape shape, std::optional<double> guess);

/// F at each row of the design.
std::vector<double> shape_over(const BayesProblem& problem, double threshold, double width);

/// Log of prior times likelihood, up to a constant; minus infinity where the prior is 0.
double log_posterior(const BayesProblem& problem, const std::vector<double>& below, const BayesPoint& at);

std::vector<std::string> priors_in_words(const BayesProblem& problem);

}  // namespace palpate::analysis
