#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "sim/model/free_state.hpp"
#include "sim/model/loads.hpp"
#include "sim/model/model.hpp"
#include "sim/model/solve_report.hpp"

namespace palpate::sim {

/// What happened between two bodies in one cycle.
struct PairSummary {
  int active = 0;                                            // colliding (node, polygon) pairs
  std::array<Vec3, 2> force_on{Vec3::Zero(), Vec3::Zero()};  // contact force on each body [N]
};

/// Buffers and warm starts of a law for one model: a law derives its own from it. All storage is taken when
/// it is made. What it holds from the cycle before changes a force by no more than the solver's tolerance (1e-10),
/// and after a reset not at all.
struct LawScratch {
  LawScratch() = default;
  LawScratch(const LawScratch&) = delete;
  LawScratch& operator=(const LawScratch&) = delete;
  virtual ~LawScratch() = default;

  /// Forgets every warm start.
  virtual void reset() {}

  std::vector<PairSummary> summaries{};  // one a pair of bodies, in the model's order
};

/// `prepare` of a law that needs its Scratch wherever bodies may touch.
template <class Scratch>
std::unique_ptr<LawScratch> prepare_where_bodies_touch(const Model& model) {
  return model.pairs.empty() ? nullptr : std::make_unique<Scratch>(model);
}

inline std::size_t no_memory(const Model&) {
  return 0;
}
inline void no_advance(const Model&, const LawScratch&, double, std::span<double>) {}

/// How bodies that touch share their displacement. The simulation owns scratch and memory and calls, in every
/// cycle, `solve` and then, where there is memory, `advance`.
struct ContactLaw {
  std::string_view name{};     // as a scene's contact.model says it
  std::string_view meaning{};  // what touching bodies do to each other, a clause, for the reference

  /// Empty where the law has nothing to do in this model: then neither `solve` nor `advance` is called.
  std::unique_ptr<LawScratch> (*prepare)(const Model& model) = nullptr;

  /// Numbers of history that the law carries from cycle to cycle; all 0 at the start.
  std::size_t (*memory_size)(const Model& model) = no_memory;

  /// Adds to `response`, which holds what the probes alone have done, what the touch of the bodies adds, and
  /// fills the scratch's summaries, which come zeroed. Allocates nothing.
  SolveReport (*solve)(const Model& model, const FreeState& free, std::span<const double> memory,
                       LawScratch& scratch, Response& response) = nullptr;

  /// Takes what the cycle that was just solved leaves behind into `memory`. @param dt  since the last one [s]
  void (*advance)(const Model& model, const LawScratch& scratch, double dt,
                  std::span<double> memory) = no_advance;

  /// Whether it finds out anew what faces what where a region takes a body far (Region::carries).
  bool follows_regions = false;
};

}  // namespace palpate::sim
