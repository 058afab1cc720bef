#include "app/loop/cycle_handover.hpp"

namespace palpate::app {

CycleHandover::CycleHandover(const sim::Model& model, const std::vector<sim::ProbeDisplacement>& probes,
                             const sim::Loads& loads)
    : model_(&model), felt_{probes, loads} {}

void CycleHandover::offer(const std::vector<sim::ProbeDisplacement>& probes, const sim::Loads& loads) {
  if (turn_.load(std::memory_order_acquire) != Turn::Asked) return;
  felt_.probes = probes;  // of equal sizes: nothing is allocated
  felt_.loads = loads;
  turn_.store(Turn::Answered, std::memory_order_release);
}

}  // namespace palpate::app
