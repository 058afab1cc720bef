#pragma once

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <limits>

namespace palpate::analysis {

/// Where a function of one variable is greatest, and how great.
struct Greatest {
  double at = 0.0;
  double value = 0.0;
};

/// Scans [from, to] at `cells` + 1 places and refines the best by Brent's method between its neighbours, on a
/// variable whose unit is a cell and whose origin is the best: how near it comes hangs on neither unit nor
/// origin of x.
template <typename Function>
Greatest greatest(const Function& function, double from, double to, int cells) {
  const double cell = (to - from) / cells;
  const auto place = [&](int i) { return from + cell * i; };
  Greatest best{.value = -std::numeric_limits<double>::infinity()};
  int where = 0;
  for (int i = 0; i <= cells; ++i) {
    const double value = function(place(i));
    if (!(value > best.value)) continue;
    best = {place(i), value};
    where = i;
  }
  const auto refined =
      boost::math::tools::brent_find_minima([&](double t) { return -function(best.at + cell * t); },
                                            where > 0 ? -1.0 : 0.0, where < cells ? 1.0 : 0.0, 26);
  return -refined.second > best.value ? Greatest{best.at + cell * refined.first, -refined.second} : best;
}

}  // namespace palpate::analysis
