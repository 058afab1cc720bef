#pragma once

#include <array>
#include <span>

#include "analysis/psychometric/design.hpp"

namespace palpate::analysis {

/// A function of the model's family on the design's scale: eta = intercept + rise v.
struct Line {
  double intercept = 0.0;
  double rise = 0.0;
  double lapse = 0.0;
};

/// A symmetric matrix over (intercept, rise, lapse) as xx, xy, xz, yy, yz, zz.
using Information = std::array<double, 6>;

/// Log likelihood without the binomial coefficients, with its derivatives by (intercept, rise, lapse).
struct Likelihood {
  double value = 0.0;
  std::array<double, 3> gradient{};
  Information observed{};  // minus the second derivatives
};

Likelihood likelihood(const Design& design, std::span<const double> correct, const Line& line);

/// Fisher's information: what `observed` is on the average over answers from this very function.
Information expected_information(const Design& design, const Line& line);

/// The value alone.
double log_likelihood(const Design& design, std::span<const double> correct, const Line& line);

/// k log p + (n - k) log q, with 0 log 0 = 0.
double log_binomial(double k, double n, double p, double q);

}  // namespace palpate::analysis
