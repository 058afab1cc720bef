#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "sim/cost/variant_result.hpp"
#include "sim/scene/scene.hpp"

namespace palpate::app {

/// What of a sweep is asked for.
struct SweepPlan {
  double depth = 0.0;    // of the press [m]
  double seconds = 1.0;  // that each variant is timed for, about
  sim::Band band{};
  std::string band_source{};
  double period = 1e3;  // of the haptic loop that advice is given for [us]
  std::string model{};  // of the contact models, exact and this one alone; empty: all
};

/// What accuracy costs in time: every variant of a scene, its errors, and what follows.
struct Sweep {
  sim::Scene scene{};
  SweepPlan plan{};
  std::vector<sim::VariantResult> variants{};
  sim::ExtrapolatedCurve reference{};
  std::optional<double> displacement_uncertainty{};  // of the reference's displacements [-]
  std::vector<sim::ForceErrors> errors{};            // in the order of the variants
  sim::Advice advice{};
};

/// Measures all variants that `finished` does not hold. `progress` is told after each, with what stands then.
/// Throws RefusedKey where the meshes are not one body's.
Sweep run_sweep(
    const sim::Scene& scene, const SweepPlan& plan, std::vector<sim::VariantResult> finished,
    const std::function<void(const std::vector<sim::VariantResult>& done, std::size_t all)>& progress);

/// What the errors of a sweep are reckoned against, and why there is no other: a sentence.
std::string reference_in_words(const Sweep& sweep);

/// The advice in one sentence.
std::string advice_in_words(const Sweep& sweep);

/// "exact, mesh 2 of 3".
std::string name_in_sweep(const Sweep& sweep, const sim::VariantResult& result);

}  // namespace palpate::app
