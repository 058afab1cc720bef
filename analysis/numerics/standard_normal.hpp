#pragma once

#include <boost/math/distributions/normal.hpp>

namespace palpate::analysis {

/// Density of the standard normal distribution.
inline double phi(double x) {
  return pdf(boost::math::normal(), x);
}

/// Its distribution function.
inline double Phi(double x) {
  return cdf(boost::math::normal(), x);
}

/// How many standard errors a two-sided interval of this level reaches to each side: 1.96 for 0.95.
inline double critical_z(double level) {
  return quantile(complement(boost::math::normal(), (1 - level) / 2));
}

}  // namespace palpate::analysis
