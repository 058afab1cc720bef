#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/psychometric/goodness.hpp"
#include "analysis/psychometric/request.hpp"

namespace palpate::analysis {

struct MeasureEstimate {
  double value = 0.0;
  Interval interval{};
};

/// What a block or a level holds on the average for its deviance to be near the chi-squared distribution.
inline constexpr double kFewestTrials = 5.0;

/// A deviance with its p by the chi-squared distribution, which is none where it has no degree of freedom or
/// what it is summed over holds fewer than kFewestTrials: the deviance of such is not near that
/// distribution, however many they are.
struct Deviance {
  double value = 0.0;
  double degrees_of_freedom = 0.0;
  double trials_each = 0.0;  // on the average
  std::optional<double> p_chi_squared{};
};

/// What `psychometric` found, ready to be written as JSON and as text.
struct PsychometricResult {
  PsychometricRequest request{};
  std::optional<std::string> why_not{};  // why there is no function of the family
  std::string status{};                  // "fitted", "separable", "no rise", "unfit levels"
  PsychometricFit fit{};
  MeasureEstimate threshold{}, slope{}, lapse{};
  std::optional<MeasureEstimate> pse{}, jnd{}, weber{};
  double log_likelihood = 0.0;          // with the binomial coefficients
  Deviance deviance{};                  // over blocks
  std::optional<Deviance> by_level{};   // over levels, where some level has several blocks
  std::optional<double> p_bootstrap{};  // of the deviance over blocks
  std::vector<BlockInfluence> blocks{};
};

/// `replicates` may be empty: then nothing is said that needs them.
PsychometricResult psychometric_result(const PsychometricRequest& request, const Fitter* fitter,
                                       const PsychometricFit& fit, const std::vector<Replicate>& replicates);

nlohmann::ordered_json to_json(const PsychometricResult& result);
std::string in_words(const PsychometricResult& result);

}  // namespace palpate::analysis
