#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "sim/cost/cycle_cost.hpp"
#include "sim/cost/reference.hpp"
#include "sim/cost/variant.hpp"

namespace palpate::sim {

/// What one variant has come to, in accuracy and in time.
struct VariantResult {
  Variant variant{};
  int nodes = 0, touchable = 0;  // of all bodies
  double edge = 0.0;             // see edge_of() [m]
  std::vector<double> forces{};  // as PressAccuracy has them [N]
  double penetration = 0.0, imbalance = 0.0, largest_jump = 0.0, force_error_bound = 0.0;
  int unsolved = 0;
  std::optional<double> displacement_error{};  // against `exact` on the finest mesh [-]
  std::vector<double> rounds{};                // medians of a cycle in each round [us]
  Percentiles time{};                          // of a cycle [us]
  double first = 0.0;                          // of a first cycle [us]
  double prepare = 0.0;                        // [s]
  std::size_t bytes = 0;
};

/// Errors of the force curve: root mean square over the press, of the reference's [-]. The parts add up to no less than
/// the whole.
struct ForceErrors {
  double whole = 0.0;
  std::optional<double>
      discretisation{};        // of `exact` on the same mesh against the limit; none without a limit
  double contact_model = 0.0;  // of the contact model against `exact` on the same mesh
  double solver = 0.0;         // of stopping early and of single precision
  bool on_front = false;       // no other variant is both more accurate and faster
};

/// In the order of the variants. @param reference  over the steps of their curves [N]
/// @param scene  whose variants they are
std::vector<ForceErrors> errors_of(const Scene& scene, std::span<const VariantResult> variants,
                                   std::span<const double> reference);

/// What finger and hand tell apart, as part of the force [-].
struct Band {
  double lower = 0.07, upper = 0.10;
};

struct Advice {
  std::optional<std::size_t> cheapest_unfelt{};  // by index
  std::optional<std::size_t> most_accurate_in_time{};
  std::string refused{};  // why there is none
};

/// The cheapest variant whose error, the reference's uncertainty added, lies below the band, and the most accurate one
/// that keeps the rate in 99.9 % of its cycles. None from a reference that does not converge, or whose uncertainty is as
/// large as the band's lower end or as all errors. @param period  of the rate [us]
Advice advise(std::span<const VariantResult> variants, std::span<const ForceErrors> errors,
              const ExtrapolatedCurve& reference, const Band& band, double period);

}  // namespace palpate::sim
