#include "sim/cost/reference.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <cstdint>
#include <stdexcept>

namespace palpate::sim {
namespace {

constexpr double kLeastOrder = 0.05,
                 kMostOrder = 20.0;  // between which the order is looked for; the least is none
constexpr double kLeastTaken = 0.5, kMostTaken = 2.0, kMostShown = 2.5;
constexpr double kSafety = 1.25, kSafetyOutOfRange = 3.0;  // [Roache1994]

/// p with (h0^p - h1^p) / (h1^p - h2^p) = ratio; the left side rises with p.
double order_of(double ratio, const double (&h)[3]) {
  const auto excess = [&](double p) {
    return (std::pow(h[0], p) - std::pow(h[1], p)) / (std::pow(h[1], p) - std::pow(h[2], p)) - ratio;
  };
  if (excess(kLeastOrder) >= 0.0) return kLeastOrder;
  if (excess(kMostOrder) <= 0.0) return kMostOrder;
  std::uintmax_t most = 100;
  const auto bracket = boost::math::tools::toms748_solve(excess, kLeastOrder, kMostOrder,
                                                         boost::math::tools::eps_tolerance<double>(40), most);
  return 0.5 * (bracket.first + bracket.second);
}

}  // namespace

double rms(std::span<const double> values) {
  double sum = 0.0;
  for (const double value : values) sum += value * value;
  return std::sqrt(sum / static_cast<double>(values.size()));
}

double rms_difference(std::span<const double> a, std::span<const double> b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
  return std::sqrt(sum / static_cast<double>(a.size()));
}

ExtrapolatedCurve extrapolate(std::span<const std::vector<double>> curves, std::span<const double> sizes) {
  if (curves.size() < 3 || sizes.size() != curves.size())
    throw std::invalid_argument("a limit is reckoned from three meshes or more");
  const std::vector<double>&coarse = curves[curves.size() - 3], &middle = curves[curves.size() - 2],
        &fine = curves.back();
  const double h[3] = {sizes[sizes.size() - 3], sizes[sizes.size() - 2], sizes.back()};
  const double before = rms_difference(coarse, middle), last = rms_difference(middle, fine),
               force = rms(fine);
  ExtrapolatedCurve reference{.forces = fine};
  const double shown = last > 0.0 ? order_of(before / last, h) : kMostOrder;
  if (shown <= kLeastOrder) {
    reference.uncertainty = last / force;
    reference.how = fmt::format(
        "the force curves of the three finest meshes do not converge: they differ by {:.2g} % and then by {:.2g} %",
        100 * before / force, 100 * last / force);
    return reference;
  }
  reference.converges = true;
  reference.order = std::clamp(shown, kLeastTaken, kMostTaken);
  const double beyond =
      std::pow(h[2], reference.order) / (std::pow(h[1], reference.order) - std::pow(h[2], reference.order));
  for (std::size_t i = 0; i < fine.size(); ++i) reference.forces[i] += beyond * (fine[i] - middle[i]);
  const bool in_range = shown >= kLeastTaken && shown <= kMostShown;
  reference.uncertainty = (in_range ? kSafety : kSafetyOutOfRange) * beyond * last / rms(reference.forces);
  reference.how = fmt::format(
      "extrapolated from exact on the three finest meshes, cut finer inside, edges of {:.2g}, {:.2g} and {:.2g} mm, whose "
      "force curves differ by {:.2g} % and {:.2g} % (order {:.2g} shown, {:.2g} taken)",
      1e3 * h[0], 1e3 * h[1], 1e3 * h[2], 100 * before / force, 100 * last / force, shown, reference.order);
  return reference;
}

}  // namespace palpate::sim
