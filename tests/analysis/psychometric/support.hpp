#pragma once

#include <random>
#include <vector>

#include "analysis/psychometric/fit.hpp"
#include "analysis/psychometric/goodness.hpp"

namespace palpate::analysis {

/// Neither guesses nor lapses.
inline constexpr PsychometricModel kNoGuess{.guess = 0, .lapse_upper = 0};

inline std::vector<Block> blocks_from(const std::vector<double>& levels, const std::vector<long>& correct,
                                      long trials) {
  std::vector<Block> blocks;
  for (std::size_t i = 0; i < levels.size(); ++i) blocks.push_back({levels[i], correct[i], trials});
  return blocks;
}

/// The example of psignifit 3's documentation of BootstrapInference (psignifit.sourceforge.net/API.html).
inline std::vector<Block> psignifit_blocks() {
  return blocks_from({0, 2, 4, 6, 8, 10}, {26, 30, 38, 46, 50, 49}, 50);
}

inline PsychometricFit fit_of(const std::vector<Block>& blocks, const PsychometricModel& model) {
  const Design design = make_design(blocks, model);
  return fit_psychometric(design, correct_in(design, blocks));
}

/// Answers of an observer whose function has this alpha and beta, [x] and [1/x].
inline std::vector<Block> simulated(const std::vector<double>& levels, long trials, Shape shape, double guess,
                                    double lapse, double alpha, double beta, std::mt19937_64& random) {
  std::vector<Block> blocks;
  for (const double level : levels) {
    const double psi =
        guess +
        (1 - guess - lapse) * shape_at(shape, beta * (to_scale(shape, level) - to_scale(shape, alpha))).below;
    blocks.push_back({level, std::binomial_distribution<long>(trials, psi)(random), trials});
  }
  return blocks;
}

}  // namespace palpate::analysis
