#pragma once

#include <span>
#include <string>
#include <vector>

namespace palpate::sim {

/// Root of the mean square of a curve's values, or of the differences of two.
double rms(std::span<const double> values);
double rms_difference(std::span<const double> a, std::span<const double> b);

/// Where force curves tend to as the mesh becomes finer.
struct ExtrapolatedCurve {
  bool converges = false;
  std::vector<double>
      forces{};              // the finest ones extrapolated; those of the finest where nothing converges [N]
  double uncertainty = 0.0;  // of them, root mean square over the curve's [-]
  double order = 0.0;        // p of the error ~ h^p that was observed, or that was taken
  std::string how{};         // in words, with what is wrong where it does not converge
};

/// Richardson's extrapolation from the three finest meshes, with the order that they show. The uncertainty is the grid
/// convergence index: 1.25 times what was added to the finest curve where the order shown is between 1/2 and 5/2, else
/// 3 times, with the order cut to 1/2 or 2. Differences that show no order above 0.05 do not converge. Source: [Roache1994].
/// @param curves  from the coarsest mesh, over the same depths [N];  sizes: h of each mesh, falling [m]
/// Throws std::invalid_argument for fewer than three.
ExtrapolatedCurve extrapolate(std::span<const std::vector<double>> curves, std::span<const double> sizes);

}  // namespace palpate::sim
