#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/numerics/result.hpp"

namespace palpate::analysis {

/// One thing was preferred to another so many times ("felt harder").
struct Comparison {
  std::string winner{};
  std::string loser{};
  long count = 1;
};

/// Throws std::invalid_argument for an item against itself and a count below 1.
void validate(const Comparison& one);

enum class ScaleModel {
  BradleyTerry,  // logit P(i over j) = s_i - s_j
  ThurstoneV     // probit P(i over j) = s_i - s_j: the unit is the standard deviation of a difference
};

/// "bradley-terry" or "thurstone"; anything else is a std::invalid_argument.
ScaleModel scale_model_from_name(std::string_view name);
std::string_view name_of(ScaleModel model);

struct ScaledItem {
  std::string name{};
  long wins = 0, losses = 0;
  double value = 0.0;
  double standard_error = 0.0;  // 0 for the reference
  Interval interval{};          // Wald
};

struct ChiSquaredTest {
  double chi_squared = 0.0;
  long degrees_of_freedom = 0;
  std::optional<double> p{};  // none without degrees of freedom
};

struct PairedScaling {
  ScaleModel model = ScaleModel::BradleyTerry;
  std::optional<std::string> reference{};  // whose value is 0; none: the values' mean is 0
  long comparisons = 0;
  std::vector<ScaledItem> items{};                // by name
  std::vector<std::vector<double>> covariance{};  // of the values, in that order
  double log_likelihood = 0.0;                    // of the comparisons in their order
  ChiSquaredTest goodness_of_fit{};               // G2 against a probability of its own for every pair
  ChiSquaredTest equality{};                      // G2 of all values alike against the model
  bool converged = false;
  Method method{};
};

/// Scale values from paired comparisons, by maximum likelihood: the Bradley-Terry model [BradleyTerry1952] or
/// Thurstone's case V [Thurstone1927]; standard errors from the expected information, as R's glm() gives them
/// [Agresti2002] section 10.6. Throws std::invalid_argument, with names, for fewer than two items, an item
/// against itself, a count below 1, an unknown reference, items that no chain of comparisons links, and items
/// that win all comparisons with the others, or none, whose values would be infinite [Ford1957].
PairedScaling paired_scaling(const std::vector<Comparison>& comparisons, ScaleModel model,
                             const std::optional<std::string>& reference = {}, double level = 0.95);

}  // namespace palpate::analysis
