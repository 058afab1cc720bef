#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "analysis/psychometric/shape.hpp"

namespace palpate::analysis {

/// The answers at one level, in one block of trials.
struct Block {
  double level = 0.0;
  long correct = 0;  // or "yes", or "the comparison felt more"
  long trials = 0;   // >= 1
};

/// What is fitted: psi(x) = guess + (1 - guess - lapse) F(x).
struct PsychometricModel {
  Shape shape = Shape::Logistic;
  double guess = 0.5;         // fixed
  double lapse_lower = 0.0;   // equal to lapse_upper: the lapse rate is fixed
  double lapse_upper = 0.05;  // Wichmann & Hill 2001a allow 0 to 0.05 or 0.06
  double threshold_at = 0.5;  // the F at which the level is called the threshold
};

bool lapse_is_free(const PsychometricModel& model);
long free_parameters(const PsychometricModel& model);  // 2 or 3

/// Throws std::invalid_argument unless 0 <= guess, 0 <= lapse_lower <= lapse_upper, guess + lapse_upper < 1
/// and 0 < threshold_at < 1.
void validate(const PsychometricModel& model);

/// Throws std::invalid_argument for no blocks, a level that is not finite or counts that cannot be.
void validate(std::span<const Block> blocks);

/// Why no function can be fitted to levels like these, whatever the answers; empty where one can.
std::optional<std::string> unfit_levels(std::span<const Block> blocks, const PsychometricModel& model);

/// The levels as the fit uses them: ordered, on the scale u of the shape, moved and stretched to v in [-1, 1]
/// so that eta = intercept + rise v has coefficients of a common size.
struct Design {
  PsychometricModel model{};
  std::vector<std::size_t> block{};  // row -> index of the block it came from
  std::vector<double> place{};       // u of each row, ascending
  std::vector<double> v{};           // (u - centre)/half_range
  std::vector<double> trials{};
  std::vector<std::size_t> group{};  // first row of each distinct level, and the number of rows at the end
  double centre = 0.0;
  double half_range = 1.0;
  double least_gap = 1.0;  // between neighbouring distinct levels, in v
};

/// Asks for blocks and a model that were validated, and levels that are fit.
Design make_design(std::span<const Block> blocks, const PsychometricModel& model);

/// Another scale of places: u = origin + unit place.
struct Placement {
  double origin = 0.0;
  double unit = 1.0;  // > 0

  double from(double u) const { return (u - origin) / unit; }
  double to(double place) const { return origin + unit * place; }
};

/// The same design with its places on another scale; v stays what it is.
Design placed(Design design, const Placement& on);

/// The numbers correct in the order of the design's rows.
std::vector<double> correct_in(const Design& design, std::span<const Block> blocks);

}  // namespace palpate::analysis
