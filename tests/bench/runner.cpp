#include "tests/bench/runner.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <ctime>
#include <stdexcept>

#include "sim/compile/compile.hpp"
#include "sim/compliance/cache.hpp"
#include "tests/support/heap_use.hpp"
#include "tests/support/places.hpp"

namespace palpate::bench {
namespace {

using Pose = std::vector<sim::ProbeDisplacement>;

constexpr double kDepth = 5e-3;            // as the paper presses; a stroke goes half as far across [m]
constexpr int kSteps = 100;                // 25 um a cycle, at 1 kHz 25 mm/s
constexpr std::size_t kEnd = kSteps - 10;  // the pose from which on it is the end
constexpr double kTurn = 1e3;              // that a turn takes at the least [us]: its clock takes less than 1

/// That this thread has had the processor [us]: what other programs take of it is not counted.
double processor_time() {
  timespec now{};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e6 * static_cast<double>(now.tv_sec) + 1e-3 * static_cast<double>(now.tv_nsec);
}

sim::Model compiled(const Row& row) {
  static sim::ComplianceCache cache("");  // rows share bodies
  const std::string file = fmt::format("{}/data/scenes/{}.toml", test::source_folder(), row.scene);
  return sim::compile(sim::load_scene(file, row.calls), cache);
}

/// There: from half the depth, where the bodies touch already, to all of it; or at that depth across, along x.
std::vector<Pose> poses_of(const Row& row, const sim::Model& model) {
  std::vector<Pose> poses;
  for (int step = 0; step <= kSteps; ++step) {
    const double way = 0.5 * kDepth * step / kSteps;
    poses.push_back(sim::displaced_by(model, row.slides ? kDepth : 0.5 * kDepth + way));
    if (row.slides) poses.back().front().from_rest += way * sim::Vec3::UnitX();
  }
  return poses;
}

int active_contacts(const sim::CycleResult& result) {
  int active = 0;
  for (const sim::PairSummary& pair : result.pairs) active += pair.active;
  return active;
}

int often_enough(double microseconds) {
  return std::max(1, static_cast<int>(std::ceil(kTurn / microseconds)));
}

}  // namespace

Runner::Runner(const Row& row)
    : row_(row), model_(compiled(row)), poses_(poses_of(row, model_)), simulation_(model_) {
  for (const Pose& pose : poses_) {
    const sim::CycleResult result = simulation_.step(pose, sim::kCyclePeriod);
    if (!sim::solved(result.solve.stop)) throw std::runtime_error(row.name + ": a cycle could not be solved");
    contacts_ = active_contacts(result);
  }
  if (model_.law->name != "none" && contacts_ == 0)
    throw std::runtime_error(row.name + ": the bodies do not touch");
  limit_ = sim::final_contact_set(model_, poses_.back(), simulation_.loads());
  allocations_ = test::heap_use([&] { there_and_back(0); }).allocations;
  const auto cycles_from = [&](std::size_t from) { return 2.0 * static_cast<double>(poses_.size() - from); };
  ways_a_turn_ = often_enough(time_cycles(0, 1) * cycles_from(0));
  ends_a_turn_ = often_enough(time_cycles(kEnd, 1) * cycles_from(kEnd));
  reads_a_turn_ = often_enough(time_reads(10));
}

double Runner::nodes() const {
  double all = 0.0;
  for (const sim::Body& body : model_.bodies) all += static_cast<double>(body.mesh->nodes.size());
  return all;
}

/// @param from  pose
void Runner::there_and_back(std::size_t from) {
  for (std::size_t pose = from; pose < poses_.size(); ++pose)
    simulation_.step(poses_[pose], sim::kCyclePeriod);
  for (std::size_t pose = poses_.size(); pose > from; --pose)
    simulation_.step(poses_[pose - 1], sim::kCyclePeriod);
}

/// @return the mean time of a cycle [us]
double Runner::time_cycles(std::size_t from, int times) {
  const double start = processor_time();
  for (int i = 0; i < times; ++i) there_and_back(from);
  return (processor_time() - start) / (2.0 * static_cast<double>(poses_.size() - from) * times);
}

/// @return the mean time of a reading [us]
double Runner::time_reads(int times) const {
  double sum = 0.0;
  const double start = processor_time();
  for (int i = 0; i < times; ++i) {
    sum += sim::read_once(limit_);
    std::atomic_signal_fence(std::memory_order_seq_cst);  // else the compiler reads once for all
  }
  const double time = (processor_time() - start) / times;
  if (!std::isfinite(sum)) throw std::runtime_error(row_.name + ": the compliance is not finite");
  return time;
}

void Runner::take_turn() {
  cycles.push_back(time_cycles(0, ways_a_turn_));
  ends.push_back(time_cycles(kEnd, ends_a_turn_));
  reads.push_back(time_reads(reads_a_turn_));
}

}  // namespace palpate::bench
