#include "sim/view/rod.hpp"

#include <cmath>
#include <numbers>

namespace palpate::sim {
namespace {

constexpr int kAround =
    32;                    // facets around the rod: its outline departs from a circle by 0.5 % of the radius
constexpr int kRings = 8;  // of each round end

RodPoint on_rod(double radius, double length, int ring, int around) {
  const bool far_end =
      ring > kRings;  // both ends have a ring at their equator; the shaft runs between the two
  const double polar = std::numbers::pi * (far_end ? ring - 1 : ring) / (2 * kRings);
  const double azimuth = 2 * std::numbers::pi * around / kAround;
  const Vec3 normal(std::sin(polar) * std::cos(azimuth), std::sin(polar) * std::sin(azimuth),
                    -std::cos(polar));
  return {radius * normal + Vec3(0, 0, far_end ? length : 0.0), normal};
}

}  // namespace

std::vector<RodPoint> rod(double radius, double length) {
  std::vector<RodPoint> points;
  for (int ring = 0; ring <= 2 * kRings; ++ring) {
    for (int around = 0; around < kAround; ++around) {
      const auto at = [&](int r, int a) { return on_rod(radius, length, ring + r, around + a); };
      for (const RodPoint& point : {at(0, 0), at(0, 1), at(1, 1), at(0, 0), at(1, 1), at(1, 0)})
        points.push_back(point);
    }
  }
  return points;
}

}  // namespace palpate::sim
