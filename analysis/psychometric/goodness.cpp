#include "analysis/psychometric/goodness.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "analysis/psychometric/measures.hpp"

namespace palpate::analysis {
namespace {

double saturated(double k, double n) {
  return log_binomial(k, n, k / n, 1 - k / n);
}

void leave_out(BlockInfluence& influence, std::span<const Block> blocks, std::size_t left_out,
               const PsychometricModel& model, const PsychometricFit& fit) {
  influence.threshold_change = influence.slope_change = std::numeric_limits<double>::quiet_NaN();
  std::vector<Block> others(blocks.begin(), blocks.end());
  others.erase(others.begin() + static_cast<std::ptrdiff_t>(left_out));
  if (others.empty() || unfit_levels(others, model)) return;
  const Design design = make_design(others, model);
  const PsychometricFit without = fit_psychometric(design, correct_in(design, others));
  const double at = model.threshold_at;
  influence.without = without.kind;
  influence.threshold_change =
      level_at(model.shape, without.alpha, without.beta, at) - level_at(model.shape, fit.alpha, fit.beta, at);
  influence.slope_change =
      slope_at(model.shape, without.alpha, without.beta, at) - slope_at(model.shape, fit.alpha, fit.beta, at);
}

}  // namespace

double deviance_of(const Design& design, std::span<const double> correct, double log_likelihood) {
  double best = 0.0;
  for (std::size_t row = 0; row < correct.size(); ++row) best += saturated(correct[row], design.trials[row]);
  return std::max(0.0, 2 * (best - log_likelihood));
}

double pooled_deviance_of(const Design& design, std::span<const double> correct, double log_likelihood) {
  double best = 0.0;
  for (std::size_t i = 0; i + 1 < design.group.size(); ++i) {
    double k = 0.0, n = 0.0;
    for (std::size_t row = design.group[i]; row < design.group[i + 1]; ++row)
      k += correct[row], n += design.trials[row];
    best += saturated(k, n);
  }
  return std::max(0.0, 2 * (best - log_likelihood));
}

std::vector<BlockInfluence> block_influence(std::span<const Block> blocks, const PsychometricModel& model,
                                            const PsychometricFit& fit) {
  const Design design = make_design(blocks, model);
  const std::vector<double> psi = fitted_psi(design, fit);
  std::vector<BlockInfluence> influence(blocks.size());
  for (std::size_t row = 0; row < psi.size(); ++row) {
    const std::size_t index = design.block[row];
    const double k = static_cast<double>(blocks[index].correct), n = design.trials[row];
    const double part = 2 * (saturated(k, n) - log_binomial(k, n, psi[row], 1 - psi[row]));
    influence[index].psi = psi[row];
    influence[index].residual = std::copysign(std::sqrt(std::max(0.0, part)), k / n - psi[row]);
    leave_out(influence[index], blocks, index, model, fit);
  }
  return influence;
}

}  // namespace palpate::analysis
