#include "sim/cost/variant_result.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace palpate::sim {
namespace {

const VariantResult& result_of(std::span<const VariantResult> variants, const Variant& variant) {
  const auto found = std::ranges::find(variants, variant, &VariantResult::variant);
  if (found == variants.end())
    throw std::logic_error(fmt::format("no variant \"{}\" was measured", name_of(variant)));
  return *found;
}

bool beats(const VariantResult& a, const ForceErrors& of_a, const VariantResult& b, const ForceErrors& of_b) {
  return a.time.median <= b.time.median && of_a.whole <= of_b.whole &&
         (a.time.median < b.time.median || of_a.whole < of_b.whole);
}

std::string why_no_advice(std::span<const ForceErrors> errors, const ExtrapolatedCurve& reference,
                          const Band& band) {
  if (!reference.converges) return reference.how;
  if (reference.uncertainty >= band.lower)
    return fmt::format("the reference itself is known to {:.2g} % only, and a finger tells {:.2g} % apart",
                       100 * reference.uncertainty, 100 * band.lower);
  const double largest = std::ranges::max(errors, {}, &ForceErrors::whole).whole;
  if (reference.uncertainty >= largest)
    return fmt::format(
        "the reference itself is known to {:.2g} % only, and no variant differs from it by more",
        100 * reference.uncertainty);
  return {};
}

}  // namespace

std::vector<ForceErrors> errors_of(const Scene& scene, std::span<const VariantResult> variants,
                                   std::span<const double> reference) {
  const bool limit = has_mesh_limit(scene);
  const double force = rms(reference);
  std::vector<ForceErrors> errors;
  for (const VariantResult& result : variants) {
    const VariantResult& exact =
        result_of(variants, exact_on(scene, result.variant.mesh, result.variant.interior));
    Variant to_the_end = result.variant;
    to_the_end.tolerance = 0.0;
    to_the_end.precision = Precision::Double;
    const VariantResult& full = result_of(variants, to_the_end);
    errors.push_back({.whole = rms_difference(result.forces, reference) / force,
                      .contact_model = rms_difference(full.forces, exact.forces) / force,
                      .solver = rms_difference(result.forces, full.forces) / force});
    if (limit) errors.back().discretisation = rms_difference(exact.forces, reference) / force;
  }
  for (std::size_t i = 0; i < errors.size(); ++i) {
    errors[i].on_front = true;
    for (std::size_t j = 0; j < errors.size(); ++j)
      if (beats(variants[j], errors[j], variants[i], errors[i])) errors[i].on_front = false;
  }
  return errors;
}

Advice advise(std::span<const VariantResult> variants, std::span<const ForceErrors> errors,
              const ExtrapolatedCurve& reference, const Band& band, double period) {
  Advice advice{.refused = why_no_advice(errors, reference, band)};
  if (!advice.refused.empty()) return advice;
  for (std::size_t i = 0; i < variants.size(); ++i) {
    if (variants[i].unsolved > 0) continue;
    auto& cheapest = advice.cheapest_unfelt;
    if (errors[i].whole + reference.uncertainty < band.lower &&
        (!cheapest || variants[i].time.median < variants[*cheapest].time.median))
      cheapest = i;
    auto& accurate = advice.most_accurate_in_time;
    if (variants[i].time.p999 <= period && (!accurate || errors[i].whole < errors[*accurate].whole))
      accurate = i;
  }
  return advice;
}

}  // namespace palpate::sim
