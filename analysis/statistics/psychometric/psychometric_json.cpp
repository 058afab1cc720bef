#include <cmath>

#include "analysis/numerics/to_json.hpp"
#include "analysis/psychometric/measures.hpp"
#include "analysis/statistics/psychometric/psychometric_result.hpp"

namespace palpate::analysis {
namespace {

using nlohmann::ordered_json;

ordered_json estimate_json(const MeasureEstimate& estimate) {
  return {{"estimate", to_json(estimate.value)}, {"interval", to_json(estimate.interval)}};
}

ordered_json estimate_json(const std::optional<MeasureEstimate>& estimate) {
  return estimate ? estimate_json(*estimate) : ordered_json(nullptr);
}

ordered_json number_json(const std::optional<double>& value) {
  return value ? to_json(*value) : ordered_json(nullptr);
}

ordered_json blocks_json(const PsychometricResult& result) {
  ordered_json blocks = ordered_json::array();
  for (std::size_t i = 0; i < result.request.blocks.size(); ++i) {
    const Block& block = result.request.blocks[i];
    ordered_json json = {{"level", block.level}, {"correct", block.correct}, {"trials", block.trials}};
    if (i < result.blocks.size()) {
      const BlockInfluence& influence = result.blocks[i];
      json["psi"] = influence.psi;
      json["deviance_residual"] = to_json(influence.residual);
      json["threshold_change_without"] = to_json(influence.threshold_change);
      json["slope_change_without"] = to_json(influence.slope_change);
    }
    blocks.push_back(json);
  }
  return blocks;
}

ordered_json by_level_json(const std::optional<Deviance>& pooled) {
  if (!pooled) return nullptr;
  return {{"estimate", to_json(pooled->value)},
          {"degrees_of_freedom", to_json(pooled->degrees_of_freedom)},
          {"p_chi_squared", number_json(pooled->p_chi_squared)}};
}

long trials_of(const std::vector<Block>& blocks) {
  long sum = 0;
  for (const Block& block : blocks) sum += block.trials;
  return sum;
}

}  // namespace

ordered_json to_json(const PsychometricResult& result) {
  const PsychometricModel& model = result.request.model;
  const PsychometricFit& fit = result.fit;
  const bool fitted = result.status == "fitted";
  const double span = 1 - model.guess - result.lapse.value;
  ordered_json threshold = estimate_json(result.threshold), slope = estimate_json(result.slope),
               lapse = estimate_json(result.lapse);
  threshold["at"] = model.threshold_at;
  threshold["psi"] = to_json(model.guess + span * model.threshold_at);
  slope["of_psi"] = to_json(span * result.slope.value);
  lapse["free"] = lapse_is_free(model);
  lapse["lower_bound"] = model.lapse_lower;
  lapse["upper_bound"] = model.lapse_upper;
  return {{"procedure", "psychometric"},
          {"status", result.status},
          {"why", result.why_not ? ordered_json(*result.why_not) : ordered_json(nullptr)},
          {"shape", name_of(model.shape)},
          {"formula", formula_of(model.shape)},
          {"n", trials_of(result.request.blocks)},
          {"guess", model.guess},
          {"threshold", threshold},
          {"slope", slope},
          {"lapse", lapse},
          {"alpha", fitted ? to_json(from_scale(model.shape, fit.alpha)) : ordered_json(nullptr)},
          {"beta", fitted ? to_json(fit.beta) : ordered_json(nullptr)},
          {"pse", estimate_json(result.pse)},
          {"jnd", estimate_json(result.jnd)},
          {"weber_fraction", estimate_json(result.weber)},
          {"log_likelihood", to_json(result.log_likelihood)},
          {"deviance",
           {{"estimate", to_json(result.deviance.value)},
            {"degrees_of_freedom", to_json(result.deviance.degrees_of_freedom)},
            {"p", number_json(result.p_bootstrap)},
            {"p_chi_squared", number_json(result.deviance.p_chi_squared)},
            {"by_level", by_level_json(result.by_level)}}},
          {"blocks", blocks_json(result)}};
}

}  // namespace palpate::analysis
