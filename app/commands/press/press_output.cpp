#include "app/commands/press/press_output.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "sim/model/probe_kind.hpp"

namespace palpate::app {
namespace {

using nlohmann::ordered_json;

ordered_json vector_json(const sim::Vec3& v) {
  return {v[0], v[1], v[2]};
}

ordered_json bodies_json(const sim::Model& model) {
  ordered_json bodies;
  for (const sim::Body& body : model.bodies) {
    const std::set<int> fixed(body.fixed.begin(), body.fixed.end());
    std::size_t free_surface = 0;
    for (const int node : body.surface->nodes) free_surface += fixed.contains(node) ? 0 : 1;
    bodies[body.name] = {{"nodes", body.mesh->nodes.size()},
                         {"free_surface_nodes", free_surface},
                         {"tetrahedra", body.mesh->tetrahedra.size()}};
  }
  return bodies;
}

ordered_json step_json(const sim::Model& model, const sim::PressStep& step) {
  ordered_json probes, pairs = ordered_json::array();
  for (std::size_t i = 0; i < model.probes.size(); ++i) {
    ordered_json& probe = probes[model.probes[i].name];
    probe = {{"force", vector_json(step.probe_forces[i])},
             {"normal_force", sim::normal_force(model.probes[i], step.probe_forces[i])}};
    if (model.probes[i].region) probe["torque"] = vector_json(step.probe_torques[i]);
  }
  for (std::size_t i = 0; i < model.pairs.size(); ++i) {
    const auto [a, b] = model.pairs[i].bodies;
    const std::string& first = model.bodies[a].name;
    const std::string& second = model.bodies[b].name;
    pairs.push_back({{"bodies", {first, second}},
                     {"active", step.pairs[i].active},
                     {"penetration", step.penetration[i]},
                     {"force_on",
                      {{first, vector_json(step.pairs[i].force_on[0])},
                       {second, vector_json(step.pairs[i].force_on[1])}}}});
  }
  return {{"depth", step.depth},
          {"force", vector_json(step.probe_forces.front())},
          {"normal_force", sim::normal_force(model.probes.front(), step.probe_forces.front())},
          {"cycle_us", step.cycle_us},
          {"probes", probes},
          {"pairs", pairs},
          {"solve",
           {{"stop", sim::to_string(step.solve.stop)},
            {"iterations", step.solve.iterations},
            {"residual", step.solve.residual},
            {"force_error_bound", step.solve.force_error_bound}}}};
}

/// @param curve  what each step gave
ordered_json curve_json(const sim::Model& model, const ordered_json& curve) {
  return {{"scene", model.scene},
          {"model", std::string(model.law->name)},
          {"units", {{"length", "m"}, {"force", "N"}}},
          {"bodies", bodies_json(model)},
          {"curve", curve}};
}

/// What touches at a step: "contacts", "overlap [mm]", "off by [N]" (at most, where it is known), "cycle [us]".
std::string touch_text(const sim::PressStep& step) {
  int active = 0;
  double overlap = 0.0;
  for (std::size_t i = 0; i < step.pairs.size(); ++i) {
    active += step.pairs[i].active;
    overlap = std::max(overlap, step.penetration[i]);
  }
  const double bound = step.solve.force_error_bound;
  return fmt::format("{:>9} {:>16.4f} {:>11} {:>11.1f}\n", active, 1e3 * overlap,
                     !std::isfinite(bound) ? "-" : fmt::format("{:.1e}", bound), step.cycle_us);
}

const std::string kTouchHeading =
    fmt::format("{:>9} {:>16} {:>11} {:>11}\n", "contacts", "overlap [mm]", "off by [N]", "cycle [us]");

}  // namespace

ordered_json press_json(const sim::Model& model, const sim::Press& press) {
  ordered_json curve = ordered_json::array();
  for (const sim::PressStep& step : press.curve) curve.push_back(step_json(model, step));
  return curve_json(model, curve);
}

ordered_json stroke_json(const sim::Model& model, const sim::Stroke& stroke) {
  ordered_json curve = ordered_json::array();
  for (std::size_t i = 0; i < stroke.steps.size(); ++i) {
    ordered_json entry = {{"time", stroke.times[i]}};
    entry.update(step_json(model, stroke.steps[i]));
    for (std::size_t k = 0; k < model.probes.size(); ++k) {
      ordered_json& probe = entry["probes"][model.probes[k].name];
      probe["displacement"] = vector_json(stroke.steps[i].probes[k].from_rest);
      if (model.probes[k].kind->turns) probe["rotation"] = vector_json(stroke.steps[i].probes[k].rotation);
    }
    curve.push_back(std::move(entry));
  }
  return curve_json(model, curve);
}

std::string press_text(const sim::Model& model, const sim::Press& press) {
  std::string text = fmt::format("{}, contact model {}\n{:>10} {:>12} {}", model.scene, model.law->name,
                                 "depth [mm]", "force [N]", kTouchHeading);
  for (const sim::PressStep& step : press.curve)
    text += fmt::format("{:>10.3f} {:>12.5f} {}", 1e3 * step.depth,
                        sim::normal_force(model.probes.front(), step.probe_forces.front()), touch_text(step));
  return text;
}

std::string stroke_text(const sim::Model& model, const sim::Stroke& stroke) {
  std::string text = fmt::format("{}, contact model {}\n{:>10}", model.scene, model.law->name, "");
  std::string units = fmt::format("{:>10}", "time [s]");
  for (const sim::Probe& probe : model.probes) {
    text += fmt::format("   {:<69}", probe.name);
    units += fmt::format("   {:>26} {:>32} {:>9}", "displacement x y z [mm]", "force x y z [N]", "normal");
  }
  text.erase(text.find_last_not_of(' ') + 1);
  text += fmt::format("\n{} {}", units, kTouchHeading);
  for (std::size_t i = 0; i < stroke.steps.size(); ++i) {
    const sim::PressStep& step = stroke.steps[i];
    text += fmt::format("{:>10.6g}", stroke.times[i]);
    for (std::size_t k = 0; k < model.probes.size(); ++k) {
      const sim::Vec3 moved = 1e3 * step.probes[k].from_rest;
      const sim::Vec3 force = step.probe_forces[k] + sim::Vec3::Zero();  // -0 is 0
      text += fmt::format("   {:>8.3f} {:>8.3f} {:>8.3f} {:>10.5f} {:>10.5f} {:>10.5f} {:>9.4f}", moved[0],
                          moved[1], moved[2], force[0], force[1], force[2],
                          sim::normal_force(model.probes[k], force) + 0.0);
    }
    text += fmt::format(" {}", touch_text(step));
  }
  return text;
}

}  // namespace palpate::app
