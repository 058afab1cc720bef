#include "analysis/psychometric/measures.hpp"

#include <cmath>
#include <limits>

#include "analysis/numerics/infinity.hpp"

namespace palpate::analysis {

double level_at(Shape shape, double alpha, double beta, double p) {
  if (std::isinf(beta)) return from_scale(shape, alpha);
  if (beta == 0) return std::numeric_limits<double>::quiet_NaN();
  return from_scale(shape, alpha + shape_quantile(shape, p) / beta);
}

double slope_at(Shape shape, double alpha, double beta, double p) {
  if (beta == 0 || std::isinf(beta)) return beta;
  const double by_place = beta * shape_at(shape, shape_quantile(shape, p)).density;
  return on_log_levels(shape) ? by_place / level_at(shape, alpha, beta, p) : by_place;
}

double half_distance(Shape shape, double alpha, double beta) {
  if (std::isinf(beta)) return 0.0;
  if (beta == 0) return kInfinity;
  return 0.5 * (level_at(shape, alpha, beta, 0.75) - level_at(shape, alpha, beta, 0.25));
}

}  // namespace palpate::analysis
