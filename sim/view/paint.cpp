#include "sim/view/paint.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <limits>

#include "sim/elasticity/stress.hpp"
#include "sim/view/colour_map.hpp"

namespace palpate::sim {
namespace {

struct Unit {
  const char* name;
  double size;  // in SI
};

/// The largest unit in which `most` is 1 or more, as it is written, of units from small to large.
Unit unit_for(double most, std::span<const Unit> units) {
  Unit best = units.front();
  for (const Unit& unit : units)
    if (most >= 0.9995 * unit.size) best = unit;
  return best;
}

/// At each corner of each drawn triangle, three in a row [m or Pa].
std::vector<double> values_of(const DrawnBody& drawn, const Body& body, const WholeBody& whole, Field field) {
  std::vector<double> values;
  values.reserve(3 * drawn.triangles.size());
  if (field == Field::Displacement) {
    for (const Triangle& triangle : drawn.triangles)
      for (const int node : triangle) values.push_back(whole.displacement.col(node).norm());
    return values;
  }
  const Eigen::VectorXd stress = von_mises(*body.mesh, body.materials, whole.displacement);
  for (const int tetrahedron : drawn.behind) values.insert(values.end(), 3, stress[tetrahedron]);
  return values;
}

Legend legend_of(Field field, double least, double most) {
  static constexpr std::array<Unit, 3> kLengths = {{{"nm", 1e-9}, {"µm", 1e-6}, {"mm", 1e-3}}};
  static constexpr std::array<Unit, 3> kStresses = {{{"Pa", 1.0}, {"kPa", 1e3}, {"MPa", 1e6}}};
  const bool length = field == Field::Displacement;
  const Unit unit = length ? unit_for(most, kLengths) : unit_for(most, kStresses);
  return {.title = length ? "displacement" : "von Mises stress",
          .unit = unit.name,
          .least = least / unit.size,
          .most = most / unit.size};
}

}  // namespace

Legend paint(Picture& picture, const Model& model, std::span<const WholeBody> bodies, Field field) {
  assert(picture.bodies.size() == model.bodies.size() && bodies.size() == model.bodies.size());
  std::vector<std::vector<double>> values;
  double least = std::numeric_limits<double>::infinity(), most = 0.0;
  for (std::size_t body = 0; body < bodies.size(); ++body) {
    values.push_back(values_of(picture.bodies[body], model.bodies[body], bodies[body], field));
    for (const double value : values.back()) {
      least = std::min(least, value);
      most = std::max(most, value);
    }
  }
  if (least > most) least = most;  // nothing is drawn
  for (std::size_t body = 0; body < values.size(); ++body) {
    DrawnBody& drawn = picture.bodies[body];
    drawn.opacity = 1.0F;
    drawn.corner_colours.resize(3, std::ssize(values[body]));
    Eigen::Index corner = 0;
    for (const double value : values[body]) {
      const Colour colour = viridis(most > least ? (value - least) / (most - least) : 0.0);
      drawn.corner_colours.col(corner++) << colour.red, colour.green, colour.blue;
    }
  }
  return legend_of(field, least, most);
}

}  // namespace palpate::sim
