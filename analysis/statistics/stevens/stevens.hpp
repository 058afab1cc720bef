#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/numerics/result.hpp"

namespace palpate::analysis {

/// One number that an examinee gave to a stimulus.
struct MagnitudeEstimate {
  std::string examinee{};
  double level = 0.0;     // > 0, of the stimulus
  double estimate = 0.0;  // > 0, in the examinee's own unit
};

/// Throws std::invalid_argument unless level and estimate are above 0 and finite.
void validate(const MagnitudeEstimate& one);

struct LevelMean {
  double level = 0.0;
  double geometric_mean = 0.0;  // over examinees, each one's own geometric mean counting once
  std::size_t examinees = 0;    // who judged this level
  std::size_t estimates = 0;
};

/// Exponents fitted to each examinee alone, and their mean: the claim is about people like those examined.
struct ExponentsOfExaminees {
  std::size_t examinees = 0;  // who judged two levels at least
  double mean = 0.0;
  double deviation = 0.0;  // standard deviation
  Interval interval{};     // Student's t, for the mean
};

struct StevensFit {
  std::size_t examinees = 0;
  std::size_t estimates = 0;
  double exponent = 0.0;
  bool perfect =
      false;  // every estimate lies on the line but for rounding: no interval, t or p can be given (NaN)
  double standard_error = 0.0;
  Interval interval{};  // Student's t
  double t = 0.0;       // of an exponent of 0
  long degrees_of_freedom = 0;
  double p = 1.0;                   // two-sided
  double residual_deviation = 0.0;  // standard deviation of log estimates about the line
  double r_squared = 0.0;           // share of the variance within examinees that the line explains
  std::vector<LevelMean> levels{};  // rising
  bool balanced = true;             // every examinee judged every level
  std::optional<ExponentsOfExaminees> by_examinee{};  // where two examinees or more judged two levels
  Method method{};
};

/// Stevens' power law, estimate = c_i level^exponent, by least squares on logarithms with a factor c_i for
/// each examinee [Stevens1957]. The interval takes single estimates as independent and the exponent as
/// everybody's; by_examinee does not. Throws std::invalid_argument for levels or estimates that are not above
/// 0, no examinee with two levels, or no estimates left over to judge the line by.
StevensFit stevens_fit(const std::vector<MagnitudeEstimate>& estimates, double level = 0.95);

}  // namespace palpate::analysis
