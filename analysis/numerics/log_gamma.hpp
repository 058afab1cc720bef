#pragma once

#include <cmath>

namespace palpate::analysis {

/// ln |Gamma(x)|. Unlike std::lgamma it writes no global sign, so that threads may call it; unlike Boost's it
/// is fast enough for a grid of posteriors.
inline double log_gamma(double x) {
  int sign = 0;
  return ::lgamma_r(x, &sign);
}

}  // namespace palpate::analysis
