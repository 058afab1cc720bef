#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "sim/contact/exact/coupling.hpp"
#include "sim/model/free_state.hpp"
#include "sim/model/model.hpp"
#include "sim/pairing/facing_pairs.hpp"

namespace palpate::sim {

/// Where a body's rest has been brought: R x + shift.
struct RigidPose {
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  Vec3 shift = Vec3::Zero();
};

/// Contacts of bodies of which at least one is carried by a region as a whole, however far: what faces what is found
/// anew in every cycle from the rest surfaces where the regions have brought them. A contact keeps its place in the
/// list: that of its node.
struct Carried {
  /// @param pairs  of carried_pairs()
  Carried(const Model& model, std::span<const FacingPair> pairs);

  std::vector<Eigen::Matrix3d> turns{};  // of each body
  std::vector<RigidPose> poses{};        // likewise
  std::vector<int> near{};               // contacts that can touch in this cycle
  PushResponse response;  // room for one contact's
  std::vector<char> is_near{};           // of each contact
  std::vector<double> rest_overlap{};    // of each contact: what counts as touching [m]
  std::vector<Vec3> looks{};             // of each contact's node, out of its own surface at rest
  std::vector<int> last{};  // of each contact: the polygon that was nearest when it was near, or -1
  double way = 0.0;  // the most that anything has moved since the beginning, all motions added [m]
  std::vector<double> far_until{};   // of each contact: it is farther than this less the way [m]
  std::vector<char> known{};         // of each contact: the system's rows of those that are known are filled
  std::vector<FacingPair> filled{};  // with these, which differ from what is now by rounding only
  std::vector<int> renewed{};        // contacts whose rows were filled in this cycle
  std::vector<std::vector<double>>
      influence{};              // of each body's touchable nodes: the most that a newton on it moves
                                // a node that can collide, for E = 1 Pa [m]
  std::vector<double> moved{};  // of each body, the most that its surface can have given way [m]
  double start = 0.0;           // how near contacts are looked for at first [m]
  double within = 0.0;          // and now
};

/// Whether a model has such bodies that may touch others.
bool carries_bodies(const Model& model);

/// Every node that may meet a surface: those that are behind it at rest never do. Their gaps are what they overlap it
/// by at rest.
std::vector<FacingPair> carried_pairs(const Model& model);

/// Brings the bodies to where the regions have them.
void carry(const Model& model, const ProbeRows& probes, Carried& carried);

/// Finds the contacts that are near, with gaps (others: so far that they never close). Those whose rows in a system are
/// others than they were are `renewed`.
void meet(const Model& model, const ProbeRows& probes, Carried& carried, std::span<FacingPair> pairs,
          std::span<double> gaps);

/// Where a contact's node is, as the polygon's body sees it, less where it was at rest; without what loads do.
Vec3 gone(const Model& model, const ProbeRows& probes, const Carried& carried, const FacingPair& pair);

/// Forgets that anything was known.
void forget(Carried& carried);

// How far the surfaces can have given way, to see whether a contact that was left out may have closed.
void begin_giving_way(Carried& carried);
void give_way(const Model& model, const FacingPair& pair, double force, Carried& carried);
/// @param forces  along the axes of all probes, in their order
void give_way(const Model& model, const ProbeRows& probes, std::span<const double> forces, Carried& carried);
/// Whether no contact that was left out can have closed; else looks farther from now on.
bool looked_far_enough(Carried& carried);

}  // namespace palpate::sim
