#include "sim/pairing/swept.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <span>

namespace palpate::sim {
namespace {

constexpr double kEdge =
    1e-9;  // of a triangle's size: along a common edge nothing slips between two triangles

/// c0 + c1 t + c2 t^2 + c3 t^3
struct Cubic {
  double c0 = 0.0, c1 = 0.0, c2 = 0.0, c3 = 0.0;

  double at(double t) const { return c0 + t * (c1 + t * (c2 + t * c3)); }
  double slope(double t) const { return c1 + t * (2.0 * c2 + t * 3.0 * c3); }
};

/// The instants between 0 and 1 where the cubic turns, ascending.
std::span<const double> turns(const Cubic& f, std::array<double, 2>& room) {
  // Its slope lies between these three [Farin2002]: of one sign they leave no turn.
  const double first = f.c1, middle = f.c1 + f.c2, last = middle + f.c2 + 3.0 * f.c3;
  if (std::min({first, middle, last}) > 0.0 || std::max({first, middle, last}) < 0.0) return {};
  std::size_t count = 0;
  const auto add = [&](double t) {
    if (t > 0.0 && t < 1.0) room[count++] = t;
  };
  const double square = f.c2 * f.c2 - 3.0 * f.c1 * f.c3;
  if (square >= 0.0) {  // both roots of 3 c3 t^2 + 2 c2 t + c1 without cancellation
    const double q = -(f.c2 + std::copysign(std::sqrt(square), f.c2));
    if (f.c3 != 0.0) add(q / (3.0 * f.c3));
    if (q != 0.0) add(f.c1 / q);
  }
  if (count == 2 && room[1] < room[0]) std::swap(room[0], room[1]);
  return {room.data(), count};
}

/// An instant, and the cubic there.
struct Instant {
  double t = 0.0, f = 0.0;
};

/// The root between two instants where the signs differ and the cubic does not turn, to 1e-10: Newton's steps, and a
/// halving where they leave the bracket.
double root(const Cubic& f, const Instant& from, const Instant& to) {
  double low = from.t, high = to.t;
  double t = low + (high - low) * from.f / (from.f - to.f);
  for (int i = 0; i < 60; ++i) {
    const double value = f.at(t), slope = f.slope(t);
    ((value >= 0.0) == (from.f >= 0.0) ? low : high) = t;
    const double step = value / slope, next = t - step;
    if (!(next >= low && next <= high)) {
      t = 0.5 * (low + high);
      continue;
    }
    t = next;
    // what a step of Newton's leaves is its square times f'' / 2 f'
    if (step * step * std::abs(f.c2 + 3.0 * f.c3 * t) <= 1e-10 * std::abs(slope)) break;
  }
  return t;
}

/// The place and the edges at corner 0, as they are at rest and what they change by until now.
struct Ways {
  Vec3 w, ab, ac;     // at rest, seen from corner 0
  Vec3 dw, dab, dac;  // until now
};

/// How far the place is before the plane, times twice the triangle's area.
Cubic height(const Ways& x) {
  const Vec3 n0 = x.ab.cross(x.ac), n1 = x.ab.cross(x.dac) + x.dab.cross(x.ac), n2 = x.dab.cross(x.dac);
  Cubic f{x.w.dot(n0), x.w.dot(n1) + x.dw.dot(n0), x.w.dot(n2) + x.dw.dot(n1), x.dw.dot(n2)};
  if (f.c0 < 0.0 && f.c0 * f.c0 <= kEdge * kEdge * std::pow(n0.squaredNorm(), 1.5)) f.c0 = 0.0;
  return f;
}

bool is_within(const Ways& x, double t) {
  const Vec3 w = x.w + t * x.dw, ab = x.ab + t * x.dab, ac = x.ac + t * x.dac;
  const Vec3 n = ab.cross(ac);
  const double whole = n.squaredNorm(), least = -kEdge * whole;
  const double of_b = n.dot(w.cross(ac)), of_c = n.dot(ab.cross(w));
  return of_b >= least && of_c >= least && whole - of_b - of_c >= least;
}

}  // namespace

int times_entered(const Vec3& rest, const Vec3& now, const SweptTriangle& triangle) {
  const auto& [a0, b0, c0] = triangle.rest;
  const auto& [a1, b1, c1] = triangle.now;
  const Ways ways{
      rest - a0, b0 - a0, c0 - a0, (now - a1) - (rest - a0), (b1 - a1) - (b0 - a0), (c1 - a1) - (c0 - a0)};
  const Cubic f = height(ways);
  std::array<double, 2> room{};
  int entered = 0;
  Instant from{0.0, f.c0};
  const auto look_until = [&](const Instant& to) {
    const bool before = from.f >= 0.0, before_then = to.f >= 0.0;
    if (before != before_then && is_within(ways, root(f, from, to))) entered += before ? 1 : -1;
    from = to;
  };
  for (const double turn : turns(f, room)) look_until({turn, f.at(turn)});
  look_until({1.0, f.at(1.0)});
  return entered;
}

}  // namespace palpate::sim
