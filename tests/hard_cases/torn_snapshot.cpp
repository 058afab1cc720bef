// 48: what one thread writes and another reads is whole.
#include <atomic>
#include <chrono>
#include <thread>

#include "app/loop/cycle_handover.hpp"
#include "base/threads/snapshot.hpp"
#include "tests/hard_cases/runs.hpp"
#include "tests/hard_cases/scenes.hpp"

namespace palpate::hard_cases {
namespace {

constexpr std::chrono::milliseconds kHammering(30);

/// Numbers with their checksum.
struct Payload {
  std::array<std::uint64_t, 12> numbers{};
  std::uint64_t sum = 0;

  static Payload of(std::uint64_t seed) {
    Payload payload;
    for (std::uint64_t& number : payload.numbers)
      payload.sum += number = seed = 6364136223846793005U * seed + 1;
    return payload;
  }
  bool whole() const {
    std::uint64_t total = 0;
    for (const std::uint64_t number : numbers) total += number;
    return total == sum;
  }
};

/// Runs `write` in a thread of its own, as fast as it can, and `read` here: how often `read` saw something torn.
template <class Write, class Read>
int hammer(Write write, Read read) {
  std::atomic<bool> done{false};
  std::thread writer([&] {
    for (std::uint64_t round = 1; !done; ++round) write(round);
  });
  int torn = 0;
  const auto until = std::chrono::steady_clock::now() + kHammering;
  while (std::chrono::steady_clock::now() < until) torn += read() ? 0 : 1;
  done = true;
  writer.join();
  return torn;
}

}  // namespace

Outcome torn_snapshot(Jitter& jitter) {
  Outcome outcome;
  base::Snapshot<Payload> snapshot;
  const int torn_states = hammer([&](std::uint64_t round) { snapshot.write(Payload::of(round)); },
                                 [&] { return snapshot.read().whole(); });
  // Whole cycles, all of whose numbers are one.
  const sim::Model model = compiled(two_boxes(jitter), "none");
  std::vector<sim::ProbeDisplacement> probes(model.probes.size());
  sim::Loads loads = sim::Simulation(model).loads();
  app::CycleHandover handover(model, probes, loads);
  const int torn_cycles = hammer(
      [&](std::uint64_t round) {
        for (sim::ProbeDisplacement& probe : probes) probe.from_rest.setConstant(static_cast<double>(round));
        for (Eigen::VectorXd& on : loads.on_body) on.setConstant(static_cast<double>(round));
        handover.offer(probes, loads);
      },
      [&] {
        handover.ask();
        std::this_thread::yield();
        const app::FeltCycle* cycle = handover.answer();
        if (cycle == nullptr) return true;
        const double number = cycle->probes.front().from_rest[0];
        bool same = true;
        for (const Eigen::VectorXd& on : cycle->loads.on_body) same &= (on.array() == number).all();
        return same;
      });
  outcome.figure = torn_states + torn_cycles;
  return outcome;
}

}  // namespace palpate::hard_cases
