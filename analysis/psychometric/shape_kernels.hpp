#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "analysis/psychometric/shape.hpp"

namespace palpate::analysis {

// shape_at, one struct a form, so that loops over levels choose the form once and not at every level.

struct LogisticKernel {
  static ShapeValue at(double eta) {
    const double e = std::exp(-std::abs(eta));
    const double large = 1 / (1 + e), small = e * large;
    const double below = eta < 0 ? small : large, above = eta < 0 ? large : small;
    const double density = below * above;
    return {below, above, density, density * (above - below)};
  }
};

struct GaussianKernel {
  static ShapeValue at(double eta) {
    const double small = 0.5 * std::erfc(std::abs(eta) * (0.5 * std::numbers::sqrt2));
    const double density = 0.5 * std::numbers::sqrt2 * std::numbers::inv_sqrtpi * std::exp(-0.5 * eta * eta);
    return {eta < 0 ? small : 1 - small, eta < 0 ? 1 - small : small, density, -eta * density};
  }
};

struct GumbelLeftKernel {
  static ShapeValue at(double eta) {
    const double hazard = std::exp(std::min(eta, 600.0));  // beyond, 1 - F is 0 in any case
    const double above = std::exp(-hazard), density = hazard * above;
    return {-std::expm1(-hazard), above, density, density * (1 - hazard)};
  }
};

struct GumbelRightKernel {
  static ShapeValue at(double eta) {
    const ShapeValue mirrored = GumbelLeftKernel::at(-eta);
    return {mirrored.above, mirrored.below, mirrored.density, -mirrored.bend};
  }
};

/// Calls `with` with the kernel of the shape.
template <typename With>
auto with_kernel(Shape shape, const With& with) {
  switch (shape) {
    case Shape::Logistic:
      return with(LogisticKernel());
    case Shape::Gaussian:
      return with(GaussianKernel());
    case Shape::GumbelRight:
      return with(GumbelRightKernel());
    case Shape::Weibull:
    case Shape::GumbelLeft:
      break;
  }
  return with(GumbelLeftKernel());
}

}  // namespace palpate::analysis
