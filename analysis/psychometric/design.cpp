#include "analysis/psychometric/design.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <stdexcept>

#include "analysis/numerics/result.hpp"

namespace palpate::analysis {

bool lapse_is_free(const PsychometricModel& model) {
  return model.lapse_lower < model.lapse_upper;
}

long free_parameters(const PsychometricModel& model) {
  return lapse_is_free(model) ? 3 : 2;
}

void validate(const PsychometricModel& model) {
  if (!(model.guess >= 0 && model.guess < 1))
    throw std::invalid_argument(fmt::format("guess is {}; accepted: 0 to below 1", model.guess));
  if (!(model.lapse_lower >= 0 && model.lapse_lower <= model.lapse_upper)) {
    throw std::invalid_argument(fmt::format("lapse from {} to {}; accepted: bounds from 0 up, in order",
                                            model.lapse_lower, model.lapse_upper));
  }
  if (!(model.guess + model.lapse_upper < 1)) {
    throw std::invalid_argument(
        fmt::format("guess {} and lapse up to {} leave the function nothing to rise through; their sum must "
                    "stay below 1",
                    model.guess, model.lapse_upper));
  }
  require_level(model.threshold_at, "threshold-at");
}

void validate(std::span<const Block> blocks) {
  if (blocks.empty()) throw std::invalid_argument("no blocks; a psychometric function needs some");
  for (const Block& block : blocks) {
    require_finite(block.level, "level");
    require_counts(block.correct, block.trials);
  }
}

std::optional<std::string> unfit_levels(std::span<const Block> blocks, const PsychometricModel& model) {
  std::set<double> levels;
  for (const Block& block : blocks) levels.insert(block.level);
  if (on_log_levels(model.shape) && *levels.begin() <= 0) {
    return fmt::format(
        "the Weibull function starts at level 0, and there is a level {}; take another shape or levels above "
        "0",
        *levels.begin());
  }
  if (std::ssize(levels) >= free_parameters(model)) return std::nullopt;
  return fmt::format(
      "{} distinct level{} for {} free parameters ({}); {}", levels.size(), levels.size() == 1 ? "" : "s",
      free_parameters(model), lapse_is_free(model) ? "threshold, slope, lapse" : "threshold, slope",
      levels.size() == 2 ? "fix the lapse rate or measure at more levels" : "measure at more levels");
}

Design make_design(std::span<const Block> blocks, const PsychometricModel& model) {
  Design design{.model = model};
  design.block.resize(blocks.size());
  std::iota(design.block.begin(), design.block.end(), std::size_t{0});
  std::ranges::stable_sort(design.block,
                           [&](std::size_t a, std::size_t b) { return blocks[a].level < blocks[b].level; });
  for (const std::size_t index : design.block) {
    const double place = to_scale(model.shape, blocks[index].level);
    if (design.place.empty() || place > design.place.back()) design.group.push_back(design.place.size());
    design.place.push_back(place);
    design.trials.push_back(static_cast<double>(blocks[index].trials));
  }
  design.group.push_back(blocks.size());
  design.centre = 0.5 * (design.place.front() + design.place.back());
  design.half_range = 0.5 * (design.place.back() - design.place.front());
  for (const double place : design.place) design.v.push_back((place - design.centre) / design.half_range);
  design.least_gap = 2.0;
  for (std::size_t row = 1; row < design.v.size(); ++row) {
    const double gap = design.v[row] - design.v[row - 1];
    if (gap > 0) design.least_gap = std::min(design.least_gap, gap);
  }
  return design;
}

Design placed(Design design, const Placement& on) {
  for (double& place : design.place) place = on.from(place);
  design.centre = on.from(design.centre);
  design.half_range /= on.unit;
  return design;
}

std::vector<double> correct_in(const Design& design, std::span<const Block> blocks) {
  std::vector<double> correct;
  for (const std::size_t index : design.block) correct.push_back(static_cast<double>(blocks[index].correct));
  return correct;
}

}  // namespace palpate::analysis
