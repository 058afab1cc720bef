#include "analysis/psychometric/start_grid.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace palpate::analysis {
namespace {

constexpr double kLog0 = -300.0;   // instead of minus infinity, which times no answers were no number
constexpr double kHopeless = 3.0;  // below the best start: no climb from there was seen to end above

double floored_log(double p) {
  return p > 0 ? std::max(std::log(p), kLog0) : kLog0;
}

}  // namespace

StartGrid::StartGrid(const Design& design) : trials_(design.trials) {
  const PsychometricModel& model = design.model;
  const double stride = std::clamp(0.5 * design.least_gap, 0.06, 0.2);
  const auto middles = static_cast<std::size_t>(std::ceil(3.2 / stride + 0.5));  // from -1.6 to 1.6
  middles_.reserve(middles);
  for (std::size_t i = 0; i < middles; ++i) middles_.push_back(-1.6 + static_cast<double>(i) * stride);
  const double steepest = std::max(8.0, std::min(6 / design.least_gap, 100.0));
  double rise = 0.6;
  while (rise < 2 * steepest) {
    rises_.push_back(rise);
    if (rise > 2.5 / design.least_gap) ++steep_rises_;
    rise *= 1.6;
  }
  steep_rises_ = std::max(steep_rises_, std::size_t{1});
  lapses_ = {model.lapse_lower};
  if (lapse_is_free(model)) {
    lapses_.push_back(0.5 * (model.lapse_lower + model.lapse_upper));
    lapses_.push_back(model.lapse_upper);
  }
  const std::size_t cells = middles_.size() * rises_.size();
  for (const double v : design.v) {
    for (const double lapse : lapses_) {
      for (std::size_t cell = 0; cell < cells; ++cell) {
        const Line at = line(cell, lapse);
        const ShapeValue shape = shape_at(model.shape, at.intercept + at.rise * v);
        const double span = 1 - model.guess - lapse;
        log_hit_.push_back(floored_log(model.guess + span * shape.below));
        log_miss_.push_back(floored_log(lapse + span * shape.above));
      }
    }
  }
}

Line StartGrid::line(std::size_t cell, double lapse) const {
  const double rise = rises_[cell / middles_.size()];
  return {.intercept = -rise * middles_[cell % middles_.size()], .rise = rise, .lapse = lapse};
}

std::vector<Line> StartGrid::starts(std::span<const double> correct) const {
  const std::size_t cells = middles_.size() * rises_.size(), steep = cells - middles_.size() * steep_rises_;
  std::vector<double> sum(cells);
  std::vector<std::pair<double, Line>> best;
  for (std::size_t l = 0; l < lapses_.size(); ++l) {
    std::ranges::fill(sum, 0.0);
    for (std::size_t row = 0; row < correct.size(); ++row) {
      const double hits = correct[row], misses = trials_[row] - hits;
      const std::size_t first = (row * lapses_.size() + l) * cells;
      const double* hit = log_hit_.data() + first;
      const double* miss = log_miss_.data() + first;
      for (std::size_t cell = 0; cell < cells; ++cell) sum[cell] += hits * hit[cell] + misses * miss[cell];
    }
    for (const auto& [first, end] : {std::pair(std::size_t{0}, steep), std::pair(steep, cells)}) {
      const auto top = std::max_element(sum.begin() + static_cast<std::ptrdiff_t>(first),
                                        sum.begin() + static_cast<std::ptrdiff_t>(end));
      best.emplace_back(*top, line(top - sum.begin(), lapses_[l]));
    }
  }
  std::ranges::sort(best, [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<Line> lines;
  for (const auto& [value, line] : best) {
    if (value > best.front().first - kHopeless) lines.push_back(line);
  }
  return lines;
}

}  // namespace palpate::analysis
