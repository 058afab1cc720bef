#include "sim/cost/cycle_cost.hpp"

#include <sys/resource.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <stdexcept>

#include "sim/cost/press_poses.hpp"

namespace palpate::sim {
namespace {

constexpr std::size_t kNeighbours = 4;  // on each side

double median_read(const ContactSet& set) {
  constexpr int kBatches = 201, kReads = 50;  // one read is near the clock's own time
  std::vector<double> times;
  double sum = 0.0;
  for (int batch = 0; batch < kBatches; ++batch) {
    const auto start = CycleClock::now();
    for (int read = 0; read < kReads; ++read) {
      sum += read_once(set);
      std::atomic_signal_fence(std::memory_order_seq_cst);  // else the compiler reads once for all
    }
    times.push_back(microseconds_since(start) / kReads);
  }
  if (!std::isfinite(sum)) throw std::runtime_error("the compliance holds numbers that are not finite");
  return percentiles_of(std::move(times)).median;
}

/// How often the system has taken the processor from this thread and given it to another.
long interruptions() {
  rusage usage{};
  getrusage(RUSAGE_THREAD, &usage);
  return usage.ru_nivcsw;
}

}  // namespace

Percentiles percentiles_of(std::vector<double> microseconds) {
  if (microseconds.empty()) throw std::invalid_argument("the spread of no times at all");
  std::ranges::sort(microseconds);
  const auto at = [&](double share) {
    const double rank = std::ceil(share * static_cast<double>(microseconds.size()));
    return microseconds[static_cast<std::size_t>(std::max(rank, 1.0)) - 1];
  };
  return {.median = at(0.5), .p99 = at(0.99), .p999 = at(0.999), .slowest = microseconds.back()};
}

ContactSet final_contact_set(const Model& model, ProbeDisplacements probes, const Loads& loads) {
  ContactSet set;
  // Nodes that a pressing probe loads: its own columns hold what they do.
  std::vector<std::vector<char>> by_probe;
  for (const Body& body : model.bodies) by_probe.emplace_back(body.rest.cols(), 0);
  for (std::size_t i = 0; i < model.probes.size(); ++i) {
    const Probe& probe = model.probes[i];
    if (!(probes[i].from_rest.dot(probe.direction) > 0.0)) continue;
    set.columns.push_back({&probe.compliance, 0, probe.compliance.cols()});
    for (const int node : probe.nodes) by_probe[probe.body][node] = 1;
  }
  for (std::size_t b = 0; b < model.bodies.size(); ++b)
    for (Eigen::Index node = 0; node < model.bodies[b].rest.cols(); ++node)
      if (!by_probe[b][node] && !loads.on_body[b].segment<3>(3 * node).isZero(0.0))
        set.columns.push_back({&model.bodies[b].compliance->touch_touch, 3 * node, 3});
  for (const ContactSet::Columns& part : set.columns)
    set.bytes += sizeof(double) * static_cast<std::size_t>(part.matrix->rows() * part.count);
  return set;
}

double read_once(const ContactSet& set) {
  double sum = 0.0;
  for (const ContactSet::Columns& part : set.columns)
    sum += part.matrix->middleCols(part.first, part.count).sum();
  return sum;
}

namespace {

/// Times of each cycle [us].
struct CycleTimes {
  std::vector<double> deformation{}, interaction{}, total{};
  std::vector<std::vector<double>> by_pose{};  // total at each pose
};

CycleTimes time_cycles(const std::vector<PressPose>& poses, const CycleSampling& sampling, Simulation& alone,
                       Simulation& whole) {
  CycleTimes times{.by_pose = std::vector<std::vector<double>>(poses.size())};
  const auto started = CycleClock::now();
  const int warm_up = 2 * static_cast<int>(poses.size());
  for (int i = 0; i < warm_up + sampling.most_cycles; ++i) {
    if (microseconds_since(started) > 1e6 * sampling.most_seconds && i > 2 * warm_up) break;
    const std::size_t p = to_and_fro(i, poses.size());
    const auto start = CycleClock::now();
    alone.step(poses[p].probes, kCyclePeriod);
    const double by_probes = microseconds_since(start);
    const auto again = CycleClock::now();
    whole.step(poses[p].probes, kCyclePeriod);
    const double all = microseconds_since(again);
    if (i < warm_up) continue;
    times.deformation.push_back(by_probes);
    times.interaction.push_back(all - by_probes);
    times.total.push_back(all);
    times.by_pose[p].push_back(all);
  }
  return times;
}

/// Times at a pose and at its neighbours [us].
std::vector<double> times_around(const std::vector<std::vector<double>>& by_pose, std::size_t pose) {
  std::vector<double> times;
  const std::size_t first = pose - std::min(pose, kNeighbours);
  for (std::size_t p = first; p < std::min(pose + kNeighbours + 1, by_pose.size()); ++p)
    times.insert(times.end(), by_pose[p].begin(), by_pose[p].end());
  return times;
}

}  // namespace

CycleCost measure_cycle(const Model& model, const ContactLaw& law, const CycleSampling& sampling) {
  if (!(sampling.depth > 0.0)) throw std::invalid_argument("a press of depth 0 has no cost to measure");
  const Model alone_model = without_contact(model), whole_model = with_law(model, law);
  Simulation alone(alone_model), whole(whole_model);
  CycleCost cost{.law = law.name};
  const std::vector<PressPose> poses = poses_to_time(model, sampling, alone, cost.touching);

  const long interrupted_before = interruptions();
  CycleTimes times = time_cycles(poses, sampling, alone, whole);
  cost.interruptions = interruptions() - interrupted_before;
  cost.cycles = static_cast<int>(times.total.size());
  cost.deformation = percentiles_of(std::move(times.deformation));
  cost.interaction = percentiles_of(std::move(times.interaction));
  cost.total = percentiles_of(std::move(times.total));
  for (std::size_t p = 0; p < poses.size(); ++p) {
    cost.depths.push_back(poses[p].depth);
    cost.depth_p999.push_back(percentiles_of(times_around(times.by_pose, p)).p999);
  }
  for (std::size_t p = 0; p < poses.size(); ++p)
    cost.depth_medians.push_back(percentiles_of(std::move(times.by_pose[p])).median);

  const CycleResult deepest = whole.step(poses.back().probes, kCyclePeriod);
  for (const PairSummary& pair : deepest.pairs) cost.active += pair.active;
  const ContactSet set = final_contact_set(whole_model, poses.back().probes, whole.loads());
  cost.limit_bytes = set.bytes;
  cost.limit = median_read(set);
  return cost;
}

}  // namespace palpate::sim
