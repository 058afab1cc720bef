#include "analysis/psychometric/likelihood.hpp"

#include <algorithm>
#include <cmath>

#include "analysis/psychometric/shape_kernels.hpp"

namespace palpate::analysis {
namespace {

constexpr double kTiny = 1e-140;  // instead of a probability of 0 in a quotient

template <typename Kernel>
Likelihood add_rows(const Design& design, std::span<const double> correct, const Line& line) {
  Likelihood sum;
  auto& g = sum.gradient;
  auto& o = sum.observed;
  const double guess = design.model.guess, span = 1 - guess - line.lapse;
  for (std::size_t row = 0; row < correct.size(); ++row) {
    const double v = design.v[row], n = design.trials[row], k = correct[row];
    const ShapeValue shape = Kernel::at(line.intercept + line.rise * v);
    const double p = std::max(guess + span * shape.below, kTiny);
    const double q = std::max(line.lapse + span * shape.above, kTiny);
    sum.value += log_binomial(k, n, p, q);
    const double by_p = 1 / p, by_q = 1 / q;
    const double hit = k * by_p, miss = (n - k) * by_q;
    const double by_psi = hit - miss;                           // dl/dpsi
    const double seen = hit * by_p + miss * by_q;               // -d2l/dpsi2
    const double px = span * shape.density, pz = -shape.below;  // dpsi/dintercept, dpsi/dlapse
    const double pxx = span * shape.bend, pxz = -shape.density;
    g[0] += by_psi * px;
    g[1] += by_psi * px * v;
    g[2] += by_psi * pz;
    const double xx = seen * px * px - by_psi * pxx, xz = seen * px * pz - by_psi * pxz;
    o[0] += xx;
    o[1] += xx * v;
    o[2] += xz;
    o[3] += xx * v * v;
    o[4] += xz * v;
    o[5] += seen * pz * pz;
  }
  return sum;
}

template <typename Kernel>
Information expected_rows(const Design& design, const Line& line) {
  Information e{};
  const double guess = design.model.guess, span = 1 - guess - line.lapse;
  for (std::size_t row = 0; row < design.v.size(); ++row) {
    const double v = design.v[row];
    const ShapeValue shape = Kernel::at(line.intercept + line.rise * v);
    const double p = std::max(guess + span * shape.below, kTiny);
    const double q = std::max(line.lapse + span * shape.above, kTiny);
    const double by_psi = design.trials[row] / p / q;
    const double px = span * shape.density, pz = -shape.below;
    const double xx = by_psi * px * px, xz = by_psi * px * pz;
    e[0] += xx;
    e[1] += xx * v;
    e[2] += xz;
    e[3] += xx * v * v;
    e[4] += xz * v;
    e[5] += by_psi * pz * pz;
  }
  return e;
}

}  // namespace

double log_binomial(double k, double n, double p, double q) {
  return (k > 0 ? k * std::log(p) : 0.0) + (k < n ? (n - k) * std::log(q) : 0.0);
}

Likelihood likelihood(const Design& design, std::span<const double> correct, const Line& line) {
  return with_kernel(design.model.shape,
                     [&](auto kernel) { return add_rows<decltype(kernel)>(design, correct, line); });
}

Information expected_information(const Design& design, const Line& line) {
  return with_kernel(design.model.shape,
                     [&](auto kernel) { return expected_rows<decltype(kernel)>(design, line); });
}

double log_likelihood(const Design& design, std::span<const double> correct, const Line& line) {
  const double guess = design.model.guess, span = 1 - guess - line.lapse;
  return with_kernel(design.model.shape, [&](auto kernel) {
    double sum = 0.0;
    for (std::size_t row = 0; row < correct.size(); ++row) {
      const ShapeValue shape = kernel.at(line.intercept + line.rise * design.v[row]);
      sum += log_binomial(correct[row], design.trials[row], std::max(guess + span * shape.below, kTiny),
                          std::max(line.lapse + span * shape.above, kTiny));
    }
    return sum;
  });
}

}  // namespace palpate::analysis
