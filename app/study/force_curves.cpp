#include "app/study/force_curves.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace palpate::app {
namespace {

constexpr double kDepthStep = 0.00025;              // of the force curves [m]
constexpr std::size_t kPresentationsOfCurve = 200;  // enough for a mean; each trace must be unpacked

// What a force curve is averaged from.
struct PressedCondition {
  trials::RunMode run_mode{};
  std::size_t cell = 0;
  std::size_t condition = 0;  // into Protocol::conditions
  // NOLINTNEXTLINE(modernize-use-nullptr): the comparison that the compiler writes has a 0 of its own
  auto operator<=>(const PressedCondition&) const = default;
};
using Pressed = std::map<PressedCondition, std::vector<std::int64_t>>;  // ids of presentations

// What the answers that count were given to.
Pressed pressed_in(const std::vector<trials::AnsweredTrial>& answered) {
  Pressed pressed;
  for (const trials::AnsweredTrial& trial : answered) {
    if (trial.void_reason) continue;
    for (const trials::PresentationRow& presentation : trial.intervals)
      pressed[{trial.session->facts.run_mode, trial.drawn.trial.cell, presentation.condition}].push_back(
          presentation.id);
  }
  return pressed;
}

// Mean and standard deviation at the depths that at least half of the presentations reached: further in, the
// mean would be that of those who press hardest.
analysis::ForceCurve curve_of(const trials::StudyFile& study, const PressedCondition& pressed,
                              const std::vector<std::int64_t>& ids) {
  const std::size_t taken = std::min(ids.size(), kPresentationsOfCurve);
  analysis::ForceCurve curve{.cell = pressed.cell,
                             .condition = study.protocol().conditions[pressed.condition].name,
                             .run_mode = std::string(trials::to_string(pressed.run_mode)),
                             .intervals = taken};
  std::vector<std::vector<double>> at_depth;
  for (std::size_t i = 0; i < taken; ++i) {
    const std::vector<double> forces = force_at_depths(study.load_trace(ids[i * ids.size() / taken]));
    if (at_depth.size() < forces.size()) at_depth.resize(forces.size());
    for (std::size_t d = 0; d < forces.size(); ++d) {
      if (!std::isnan(forces[d])) at_depth[d].push_back(forces[d]);
    }
  }
  for (std::size_t d = 0; d < at_depth.size(); ++d) {
    const std::vector<double>& forces = at_depth[d];
    if (forces.empty() || 2 * forces.size() < taken) continue;
    const double n = static_cast<double>(forces.size());
    double mean = 0.0, squares = 0.0;
    for (const double force : forces) mean += force / n;
    for (const double force : forces) squares += (force - mean) * (force - mean);
    curve.depth_m.push_back(kDepthStep * static_cast<double>(d));
    curve.mean_force_n.push_back(mean);
    curve.deviation_n.push_back(forces.size() > 1 ? std::sqrt(squares / (n - 1)) : 0.0);
  }
  return curve;
}

}  // namespace

std::vector<double> force_at_depths(const trials::Trace& trace) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  std::vector<double> sums, counts;
  const auto magnitude = [](const trials::TraceSample& sample) {
    return std::hypot(static_cast<double>(sample.force[0]), static_cast<double>(sample.force[1]),
                      static_cast<double>(sample.force[2]));
  };
  for (std::size_t i = 1; i < trace.size(); ++i) {
    const double before = static_cast<double>(trace[i - 1].depth),
                 after = static_cast<double>(trace[i].depth);
    if (!(after > before) || after <= 0) continue;
    for (double d = std::max(0.0, std::ceil(before / kDepthStep)); d * kDepthStep < after; ++d) {
      const double share = (d * kDepthStep - before) / (after - before);
      const auto index = static_cast<std::size_t>(d);
      if (index >= sums.size()) sums.resize(index + 1, 0.0), counts.resize(index + 1, 0.0);
      sums[index] += (1 - share) * magnitude(trace[i - 1]) + share * magnitude(trace[i]);
      ++counts[index];
    }
  }
  for (std::size_t d = 0; d < sums.size(); ++d) sums[d] = counts[d] > 0 ? sums[d] / counts[d] : kNone;
  return sums;
}

void add_curves(const trials::StudyFile& study, const std::vector<trials::AnsweredTrial>& answered,
                analysis::StudyTable& table) {
  const std::vector<std::string>& order = table.design.conditions;
  for (const auto& [pressed, ids] : pressed_in(answered))
    table.curves.push_back(curve_of(study, pressed, ids));
  const auto place = [&](const std::string& condition) {
    return std::ranges::find(order, condition) - order.begin();
  };
  std::ranges::stable_sort(table.curves, [&](const auto& a, const auto& b) {
    return std::pair(a.cell, place(a.condition)) < std::pair(b.cell, place(b.condition));
  });
}

}  // namespace palpate::app
