#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace palpate::analysis {

/// Answers of one examinee at one level: `ones` of `trials` were 1 ("harder", or correct).
struct LevelAnswers {
  std::string examinee{};
  double level = 0.0;
  long ones = 0;
  long trials = 1;
};

/// The same for the mixed model: levels standardised, answers of one examinee at one level joined (the
/// likelihood does not change but for a constant, kept in log_ways), examinees one after the other.
struct Observations {
  std::vector<double> x{};           // (level - centre)/scale
  std::vector<double> ones{};        // as many as x
  std::vector<double> trials{};      // as many as x
  std::vector<std::size_t> first{};  // where each examinee begins; one more than there are examinees
  double centre = 0.0;               // mean level, each answer counting once
  double scale = 1.0;                // standard deviation of the levels
  double log_ways = 0.0;             // sum of the log binomial coefficients of the rows as they were given
  std::size_t rows = 0;              // as they were given
  long total_trials = 0;
  long total_ones = 0;

  std::size_t examinees() const { return first.size() - 1; }
};

/// Throws std::invalid_argument, with the reason, where no mixed model with a slope over level can be fitted:
/// counts that cannot be, fewer than two examinees, fewer than two levels, all answers alike, or answers that
/// the level separates completely, pooled or for every examinee, so that the slope has no finite estimate.
Observations observations(const std::vector<LevelAnswers>& answers);

}  // namespace palpate::analysis
