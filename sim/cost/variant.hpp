#pragma once

#include <string>
#include <vector>

#include "sim/scene/scene.hpp"

namespace palpate::sim {

/// One way to simulate a scene, of those that `palpate cost` compares.
struct Variant {
  std::string model{};     // the contact model
  bool friction = false;   // with the scene's friction
  double tolerance = 0.0;  // contact.tolerance [-]
  int mesh = 0;            // 0: the meshes that the scene names; i: the i-th of their refinements
  int interior = 0;        // cuts inside beyond the scene's own
  Precision precision = Precision::Double;

  bool operator==(const Variant&) const = default;
};

/// "exact, 1 % early, mesh 2": what sets it apart, in words.
std::string name_of(const Variant& variant);

/// How many meshes of each body the scene names: 1 without refinements. Bodies without refinements keep theirs.
/// Throws RefusedKey where two bodies have unequal numbers of them.
int meshes_of(const Scene& scene);

/// Whether forces tend to a limit as the meshes become finer: no probe is a point.
bool has_mesh_limit(const Scene& scene);

/// What the scene is compared with itself as, mesh by mesh from the coarsest: every contact model; `exact` with the
/// scene's friction, where it may stop early, in single precision (where its compliance is a constant), and cut finer inside.
/// Without a mesh limit: on the scene's own meshes alone. The first one of each mesh that is_reference() is `exact`.
std::vector<Variant> variants_of(const Scene& scene);

/// `exact`, with the scene's friction: what contact models are compared with on the same mesh.
Variant exact_on(const Scene& scene, int mesh, int interior = 0);

/// The most accurate one of a mesh, cut finer inside: what the limit of ever finer meshes is reckoned from.
Variant best_of(const Scene& scene, int mesh);

Scene with_variant(Scene scene, const Variant& variant);

}  // namespace palpate::sim
