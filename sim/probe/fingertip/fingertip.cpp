#include "sim/probe/fingertip/fingertip.hpp"

#include <array>
#include <cmath>
#include <set>

#include "sim/probe/skin/skin.hpp"

namespace palpate::sim {
namespace {

void touch_from_outside(const ProbeSpec& spec, const TetMesh& mesh, const Surface& surface, int middle,
                        Probe& probe) {
  const Skin skin = skin_of(mesh, surface);
  refuse_smaller_than_mesh(spec, skin, middle);
  Fingertip tip{.radius = spec.radius, .centre = mesh.nodes[middle] - spec.radius * spec.direction};
  const auto within = [&](int node) {
    return across(spec, mesh, middle, node) < spec.radius + spec.reach &&
           skin.outward.at(node).dot(spec.direction) < 0.0;
  };
  const std::set<int> nodes = connected(skin, middle, within);
  tip.nodes.assign(nodes.begin(), nodes.end());
  probe.tip = std::make_shared<const Fingertip>(std::move(tip));
}

void prescribe_centre(const Probe& probe, const ProbeDisplacement& displacement, ProbeRow& row) {
  row.centre = probe.tip->centre + displacement.from_rest;
}

constexpr std::string_view kOneSided = "what it touches is not held, and its law prescribes displacements";
constexpr std::array kExcludes{
    Exclusion{Choice::ContactModel, "kuroda", kOneSided},
    Exclusion{Choice::ContactModel, "sibille", kOneSided},
    Exclusion{Choice::Effect, "friction", "it slides without friction, and friction is for all contacts"},
};

}  // namespace

bool meet_tip(const Body& body, const Fingertip& tip, const Vec3& direction, const Vec3& centre,
              FacingPair& pair) {
  const Vec3 from_centre = Vec3(body.rest.col(pair.node)) - centre;
  const double distance = from_centre.norm(), along = from_centre.dot(direction);
  if (distance >= tip.radius) {
    pair.normal = from_centre / distance;
    pair.gap = distance - tip.radius;
    return along > 0.0 &&
           pair.gap < tip.radius;  // what is behind the middle, or a radius away, does not come to it
  }
  const Vec3 beside = from_centre - along * direction;
  const double front = std::sqrt(tip.radius * tip.radius - beside.squaredNorm());
  pair.normal = (beside + front * direction) / tip.radius;
  pair.gap = (along - front) * front / tip.radius;
  return true;
}

constinit const ProbeKind kFingertip{
    .keys =
        {.name = "fingertip",
         .meaning =
             "a sphere of `radius` that touches from outside and only pushes; it slides as far as its `reach`",
         .takes_radius = true,
         .takes_reach = true},
    .excludes = kExcludes,
    .hold = touch_from_outside,
    .prescribe = prescribe_centre};

}  // namespace palpate::sim
