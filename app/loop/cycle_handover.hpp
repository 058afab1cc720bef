#pragma once

#include <atomic>
#include <vector>

#include "sim/model/free_state.hpp"
#include "sim/model/loads.hpp"
#include "sim/model/model.hpp"

namespace palpate::app {

/// What the hand felt in one cycle: where the probes were, and the loads that this put on the bodies.
struct FeltCycle {
  std::vector<sim::ProbeDisplacement> probes;
  sim::Loads loads;
};

/// Hands whole cycles from the haptic loop to one other thread that asks for them: the screen, which so draws
/// what the hand felt and solves nothing again. The loop copies a cycle where it was asked to, which is once a
/// picture; else it reads one atomic word. There is one copy, sized here, and `turn_` says who may touch it:
/// nobody waits, nothing is torn.
class CycleHandover {
 public:
  /// @param probes, loads  of the sizes that offer() will be given
  CycleHandover(const sim::Model& model, const std::vector<sim::ProbeDisplacement>& probes,
                const sim::Loads& loads);

  // For the one thread that reads.
  /// Asks for the next cycle. What answer() gave before is not to be looked at any more.
  void ask() { turn_.store(Turn::Asked, std::memory_order_release); }
  /// The cycle that was asked for, once it has come; it stays as it is until the next ask().
  const FeltCycle* answer() const {
    return turn_.load(std::memory_order_acquire) == Turn::Answered ? &felt_ : nullptr;
  }
  const sim::Model& model() const { return *model_; }

  /// For the loop, once a cycle. Allocates nothing.
  void offer(const std::vector<sim::ProbeDisplacement>& probes, const sim::Loads& loads);

 private:
  enum class Turn { Idle, Asked, Answered };

  const sim::Model* model_;
  FeltCycle felt_;  // written while Asked, read while Answered
  std::atomic<Turn> turn_{Turn::Idle};
};

}  // namespace palpate::app
