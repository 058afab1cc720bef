#include "analysis/psychometric/climb.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace palpate::analysis {
namespace {

using Step = std::array<double, 3>;

constexpr int kMostIterations = 100;
constexpr int kMostHalvings = 40;
constexpr double kLeastGain = 1e-13;  // of log likelihood, by scoring, which closes in by a factor
constexpr double kNewtonGain = 1e-9;  // by Newton's method, which squares what is left
constexpr double kRoundOff = 1e-12;   // of it, relative: a fall by less is none
constexpr double kLeastRise = 1e-7;   // eta over half the range of levels
constexpr double kSteepest = 60.0;    // eta between neighbouring levels: F goes from 1e-13 to 1 - 1e-13

// Solves the upper left 2 x 2 part; empty unless it is positive definite.
std::optional<Step> solve_two(const Information& m, double gx, double gy, double z) {
  const double bx = gx - m[2] * z, by = gy - m[4] * z;
  const double determinant = m[0] * m[3] - m[1] * m[1];
  if (!(m[0] > 0 && determinant > 1e-14 * m[0] * m[3])) return std::nullopt;
  return Step{(m[3] * bx - m[1] * by) / determinant, (m[0] * by - m[1] * bx) / determinant, z};
}

// The summit of the parabola whose curvature is -m, with z between its ends; empty unless m is positive
// definite. One bounded variable: a summit beyond an end has the best point at that end.
std::optional<Step> summit(const Information& m, const std::array<double, 3>& g, double z_lower,
                           double z_upper) {
  if (z_lower == z_upper) return solve_two(m, g[0], g[1], z_lower);
  if (!(m[0] > 0)) return std::nullopt;
  const double l10 = m[1] / m[0], l20 = m[2] / m[0];  // LDL^T
  const double d1 = m[3] - l10 * m[1];
  if (!(d1 > 1e-14 * m[3])) return std::nullopt;
  const double l21 = (m[4] - l10 * m[2]) / d1;
  const double d2 = m[5] - l20 * m[2] - l21 * l21 * d1;
  if (!(d2 > 1e-14 * m[5])) return std::nullopt;
  const double y1 = g[1] - l10 * g[0], y2 = g[2] - l20 * g[0] - l21 * y1;
  const double z = y2 / d2;
  if (z < z_lower || z > z_upper) return solve_two(m, g[0], g[1], std::clamp(z, z_lower, z_upper));
  const double y = y1 / d1 - l21 * z;
  return Step{g[0] / m[0] - l10 * y - l20 * z, y, z};
}

struct Direction {
  Step step{};
  bool newton = false;
};

Direction uphill(const Design& design, const Line& line, const Likelihood& here, double z_lower,
                 double z_upper) {
  const bool held = (z_lower == 0 && here.gradient[2] <= 0) || (z_upper == 0 && here.gradient[2] >= 0);
  if (held) z_lower = z_upper = 0;  // at its bound and pushed against it
  if (const auto newton = summit(here.observed, here.gradient, z_lower, z_upper)) return {*newton, true};
  Information ridged = expected_information(design, line);  // positive semidefinite by its making
  for (const std::size_t diagonal : {0U, 3U, 5U}) ridged[diagonal] = ridged[diagonal] * (1 + 1e-6) + 1e-10;
  if (const auto scoring = summit(ridged, here.gradient, z_lower, z_upper)) return {*scoring};
  return {};
}

Line moved(const Line& from, const Step& step, double share) {
  return {.intercept = from.intercept + share * step[0],
          .rise = from.rise + share * step[1],
          .lapse = from.lapse + share * step[2]};
}

// Whether a climb that is about to be at `next` ends where the rival stands.
bool meets(const Line& next, const Line& rival) {
  const double near = 0.01 * (1 + rival.rise);
  return std::abs(next.rise - rival.rise) < near && std::abs(next.intercept - rival.intercept) < near &&
         std::abs(next.lapse - rival.lapse) < 0.002;
}

}  // namespace

Summit climb(const Design& design, std::span<const double> correct, const Line& start, const Summit* rival) {
  const double lapse_lower = design.model.lapse_lower, lapse_upper = design.model.lapse_upper;
  const double steepest = kSteepest / design.least_gap;
  Summit at{.line = start};
  Likelihood here = likelihood(design, correct, at.line);
  while (at.iterations < kMostIterations && at.line.rise > kLeastRise && at.line.rise < steepest) {
    ++at.iterations;
    const auto [step, newton] =
        uphill(design, at.line, here, lapse_lower - at.line.lapse, lapse_upper - at.line.lapse);
    const double gain = step[0] * here.gradient[0] + step[1] * here.gradient[1] + step[2] * here.gradient[2];
    if (!(gain > 0)) break;
    // The parabola's summit is gain/2 higher: twice that leaves it room to be wrong.
    if (rival && newton && here.value + gain < rival->log_likelihood) break;
    if (rival && newton && meets(moved(at.line, step, 1.0), rival->line)) break;
    // The slope stays positive: a step goes at most four fifths of the way to zero.
    double share = step[1] < -0.8 * at.line.rise ? -0.8 * at.line.rise / step[1] : 1.0;
    const double floor = here.value - kRoundOff * (1 + std::abs(here.value));
    Line line = moved(at.line, step, share);
    Likelihood there = likelihood(design, correct, line);
    for (int i = 0; i < kMostHalvings && !(there.value >= floor); ++i) {
      share *= 0.5;
      line = moved(at.line, step, share);
      there = likelihood(design, correct, line);
    }
    if (!(there.value >= floor)) break;
    line.lapse = std::clamp(line.lapse, lapse_lower, lapse_upper);  // against round-off alone
    at.line = line;
    here = there;
    if (gain < (newton ? kNewtonGain : kLeastGain)) break;
  }
  at.log_likelihood = here.value;
  return at;
}

}  // namespace palpate::analysis
