#include "app/commands/press/press_path.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <stdexcept>

#include "base/files/read_file.hpp"
#include "devices/scripted/path.hpp"
#include "sim/cycle/depth_warnings.hpp"
#include "sim/model/probe_kind.hpp"
#include "sim/probe/kinds.hpp"
#include "sim/scene/accepted.hpp"

namespace palpate::app {
namespace {

using devices::ProbePath;

[[noreturn]] void refuse(const std::string& file, const ProbePath& path, std::string_view column,
                         std::string_view what) {
  throw std::invalid_argument(fmt::format("{}:{}: {}.{}: {}", file, path.line, path.probe, column, what));
}

/// "accepted: ..., or a probe of kind region".
std::string who_turns() {
  std::vector<std::string_view> turning;
  for (const sim::ProbeKind* kind : sim::probe_kinds())
    if (kind->turns) turning.push_back(kind->keys.name);
  return turning.empty() ? "" : fmt::format(", or a probe of kind {}", fmt::join(turning, " or "));
}

/// The probe that a path moves, by its index in the model.
std::size_t probe_of(const sim::Model& model, const ProbePath& path, const std::string& file) {
  const auto found = std::ranges::find(model.probes, path.probe, &sim::Probe::name);
  if (found == model.probes.end()) {
    std::vector<std::string_view> names;
    for (const sim::Probe& probe : model.probes) names.push_back(probe.name);
    refuse(file, path, "x_m",
           fmt::format("\"{}\" is no probe of this scene; accepted: {}", path.probe, fmt::join(names, ", ")));
  }
  if (!path.rotations.empty() && !found->kind->turns)
    refuse(file, path, "rx_rad",
           fmt::format("probes of kind {0} do not turn; accepted: the file without {1}.rx_rad, {1}.ry_rad, "
                       "{1}.rz_rad{2}",
                       found->kind->keys.name, path.probe, who_turns()));
  return static_cast<std::size_t>(found - model.probes.begin());
}

}  // namespace

namespace {

/// Whether a probe of this kind can take what it holds elsewhere, in this scene.
bool can_go(const sim::Scene& scene, const sim::ProbeSpec& probe) {
  const auto kinds = sim::probe_kind_keys();
  const sim::ProbeKindKeys& kind = *std::ranges::find(kinds, probe.kind, &sim::ProbeKindKeys::name);
  if (!kind.takes_group) return kind.takes_reach;
  const auto body = std::ranges::find(scene.bodies, probe.body, &sim::BodySpec::name);
  const auto others = std::ranges::count(scene.probes, probe.body, &sim::ProbeSpec::body);
  return kind.takes_reach && body != scene.bodies.end() && !body->fixed && others == 1;
}

/// How far a path goes across a direction, or how much it turns what is a metre away [m].
double reach_of(const ProbePath& path, const sim::Vec3& direction) {
  double reach = 0.0;
  for (const sim::Vec3& place : path.places) reach = std::max(reach, place.cross(direction).norm());
  for (const sim::Vec3& rotation : path.rotations) reach = std::max(reach, rotation.norm());
  return reach;
}

}  // namespace

void let_reach(sim::Scene& scene, const std::string& file) {
  for (const ProbePath& path : devices::parse_path(base::read_file(file, "a path (.csv)"), file)) {
    const auto probe = std::ranges::find(scene.probes, path.probe, &sim::ProbeSpec::name);
    if (probe != scene.probes.end() && probe->reach == 0.0 && can_go(scene, *probe))
      probe->reach = reach_of(path, probe->direction);
  }
}

std::vector<sim::StrokePose> read_stroke(const sim::Model& model, const std::string& file) {
  const std::vector<ProbePath> paths = devices::parse_path(base::read_file(file, "a path (.csv)"), file);
  const std::vector<double>& times = paths.front().times;
  std::vector<sim::StrokePose> poses;
  poses.reserve(times.size());
  for (const double time : times)
    poses.push_back({time, std::vector<sim::ProbeDisplacement>(model.probes.size())});
  for (const ProbePath& path : paths) {
    const std::size_t probe = probe_of(model, path, file);
    for (std::size_t i = 0; i < times.size(); ++i) {
      poses[i].probes[probe].from_rest = path.places[i];
      if (!path.rotations.empty()) poses[i].probes[probe].rotation = path.rotations[i];
    }
  }
  return poses;
}

std::set<std::string> stroke_warnings(const sim::Model& model, const sim::Stroke& stroke) {
  std::set<std::string> warnings;
  for (std::size_t k = 0; k < model.probes.size(); ++k) {
    const auto depth = [&](const sim::PressStep& step) {
      return step.probes[k].from_rest.dot(model.probes[k].direction);
    };
    const sim::PressStep& deepest = *std::ranges::max_element(stroke.steps, {}, depth);
    sim::Simulation there(model);
    there.step(deepest.probes, sim::kCyclePeriod);
    warnings.insert(sim::depth_warning(model, model.probes[k], depth(deepest), there.loads()));
  }
  warnings.erase("");
  return warnings;
}

}  // namespace palpate::app
