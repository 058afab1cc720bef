#pragma once

#include <Eigen/Core>
#include <array>
#include <memory>
#include <string>
#include <vector>

#include "sim/compliance/compliance.hpp"
#include "sim/elasticity/stiffness.hpp"
#include "sim/mesh/surface.hpp"
#include "sim/mesh/tet_mesh.hpp"
#include "sim/model/region.hpp"
#include "sim/scene/scene.hpp"
#include "sim/surface/aabb_tree.hpp"
#include "sim/surface/touch_surface.hpp"

namespace palpate::sim {

struct ContactLaw;
struct ProbeKind;

/// An elastic body as the haptic cycle sees it. Vectors over its touchable nodes have 3t entries, x y z of
/// each.
struct Body {
  std::string name{};
  std::shared_ptr<const TetMesh> mesh{};           // at rest, placed in the scene [m]
  std::shared_ptr<const Surface> surface{};        // its whole boundary, for pictures
  std::vector<Material> materials{};               // as stiffness() takes them
  std::vector<int> fixed{};                        // mesh nodes that never move
  int interior = 0;                                // how often it is cut finer inside, see finer_inside()
  double young_modulus = 0.0;                      // E [Pa]
  std::shared_ptr<const Compliance> compliance{};  // of the same body with E = 1 Pa: u = C f / E
  std::vector<int> touch_of_node{};    // touch index of each mesh node, -1 where it cannot be touched
  Eigen::Matrix3Xd rest{};             // of the touchable nodes, 3 x t [m]
  TouchSurface polygons{};             // what can collide, by touch index
  std::vector<int> colliding_nodes{};  // touch indices of the polygons' nodes, ascending
  AabbTree tree{};                     // over the polygons at rest
  std::vector<int> probes{};           // those that press this body, by index into Model::probes
};

/// A place that a probe may slide to, at a node of the surface: how it would hold its nodes there.
struct Knot {
  Vec3 place = Vec3::Zero();     // at rest [m]
  Eigen::VectorXd weights{};     // of the probe's nodes, sum 1
  Eigen::MatrixXd compliance{};  // as Probe::compliance
};

/// The surface over which a probe slides; no knots: it stays where it is.
struct Slide {
  Vec3 start = Vec3::Zero();  // where the probe rests [m]
  std::vector<Knot> knots{};
  std::vector<Triangle> triangles{};  // between knots, those that face the probe
};

/// A rigid sphere that presses from outside: nothing holds to it.
struct Fingertip {
  double radius = 0.0;         // [m]
  Vec3 centre = Vec3::Zero();  // where it touches the surface at rest [m]
  std::vector<int> nodes{};    // that it may meet: touch indices, as mesh nodes until the body is condensed
};

/// What presses: holds the weighted mean of its nodes, and spreads its force with the same weights. While it
/// presses (displacement . direction > 0) it prescribes W u = d along its axes.
struct Probe {
  std::string name{};
  const ProbeKind* kind = nullptr;  // of the one list
  int body = 0;
  Vec3 direction = Vec3::UnitZ();  // unit length
  double depth = 0.0;              // default depth of a press [m]
  Tangential tangential = Tangential::Held;
  Vec3 at = Vec3::Zero();         // rest position of what it holds [m]
  std::vector<int> nodes{};       // touch indices
  std::vector<double> weights{};  // of each node, sum 1
  Eigen::Matrix3Xd axes{};        // prescribed directions as columns: 3 (held) or 1 (free)
  Eigen::MatrixXd compliance{};   // displacement of the touchable nodes per newton along each axis, for
                                  // E = 1 Pa, 3t x rows [m/N]
  Slide slide{};
  std::shared_ptr<const Fingertip> tip{};  // of a kind that touches from outside: then no nodes and no axes
  std::shared_ptr<const Region>
      region{};  // of a kind that holds one: then no nodes and no axes, and `at` is the centre
};

struct TouchPair {
  std::array<int, 2> bodies{};
  std::array<bool, 2> meets{true, true};  // whether the nodes of each body meet the other's polygons (exact)
};

/// A scene compiled: constant while the haptic loop runs, shared by threads.
struct Model {
  std::string scene{};
  const ContactLaw* law = nullptr;  // of the one list; its name is the scene's contact.model
  std::vector<Body> bodies{};       // those present
  std::vector<TouchPair> pairs{};   // those of present bodies
  std::vector<Probe> probes{};
  double friction = 0.0;  // coefficient of Coulomb, of a law with friction [-]
  double contact_tolerance =
      0.0;  // part of each probe's force that a law may be wrong by, where it knows a bound
  Precision contact_precision = Precision::Double;  // of exact's compliance
  Reading reading = Reading::EveryPair;             // of kuroda
  double overlap = 0.0;                             // of bodies at rest, that the scene declares [m]
};

/// The same bodies and probes, and no body touches another.
Model without_contact(Model model);

}  // namespace palpate::sim
