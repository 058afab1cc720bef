#include "app/commands/press/press_plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace palpate::app {
namespace {

constexpr double kNear = 0.5;  // share of the limit from which on a press comes near it

/// What the finger feels over its depth, from the surface on: mm, N.
PlotSeries curve_of(const std::string& name, const sim::Model& model, const sim::Press& press) {
  PlotSeries force{.name = name, .x = {0.0}, .y = {0.0}};
  for (const sim::PressStep& step : press.curve) {
    force.x.push_back(1e3 * step.depth);
    force.y.push_back(sim::normal_force(model.probes.front(), step.probe_forces.front()));
  }
  return force;
}

/// The device's limit, in the scene's newtons: before they are scaled for the device.
void add_device_limit(const trials::ObserverParameters& people, Plot& plot) {
  if (!std::isfinite(people.device.max_force)) return;
  const double limit = people.device.max_force / people.device.force_scale;
  const std::string scale = people.device.force_scale == 1.0
                                ? ""
                                : fmt::format(" ({:g} N in the hand, forces scaled by {:g})",
                                              people.device.max_force, people.device.force_scale);
  double largest = 0.0;
  for (const PlotPanel& panel : plot.panels)
    for (const PlotSeries& series : panel.series)
      largest = std::max(largest, *std::ranges::max_element(series.y));
  if (largest >= kNear * limit) plot.limits = {{fmt::format("device's limit: {:.3g} N", limit), limit}};
  const char* reached = largest > limit            ? "forces above it are not displayed"
                        : largest >= kNear * limit ? "no press reaches it"
                                                   : "too far above to be drawn";
  plot.note += fmt::format("; device's limit {:.3g} N{} as observer \"{}\" has it: {}", limit, scale,
                           people.name, reached);
}

}  // namespace

Plot press_plot(const sim::Model& model, const sim::Press& press) {
  return {.title = fmt::format("{}, contact model {}", model.scene, model.law->name),
          .note = "force that resists the press over its depth",
          .x_label = "depth [mm]",
          .y_label = "force [N]",
          .panels = {{.series = {curve_of("force", model, press)}}}};
}

Plot stroke_plot(const sim::Model& model, const sim::Stroke& stroke) {
  Plot plot{.title = fmt::format("{}, contact model {}", model.scene, model.law->name),
            .note = "force on each probe along a path: its components, and what resists the press (normal)",
            .x_label = "time [s]",
            .y_label = "force [N]"};
  for (std::size_t k = 0; k < model.probes.size(); ++k) {
    PlotPanel panel{.title = model.probes[k].name, .series = {{"x"}, {"y"}, {"z"}, {"normal"}}};
    for (std::size_t i = 0; i < stroke.steps.size(); ++i) {
      const sim::Vec3& force = stroke.steps[i].probe_forces[k];
      const double values[] = {force[0], force[1], force[2], sim::normal_force(model.probes[k], force)};
      for (std::size_t series = 0; series < 4; ++series) {
        panel.series[series].x.push_back(stroke.times[i]);
        panel.series[series].y.push_back(values[series]);
      }
    }
    plot.panels.push_back(std::move(panel));
  }
  return plot;
}

Plot study_press_plot(const trials::Protocol& protocol, const std::vector<PressedStimulus>& pressed,
                      const trials::ObserverParameters& people) {
  Plot plot{.title = fmt::format("{}: what each condition feels like", protocol.name),
            .note = "force that resists the press over its depth, a panel for each cell of the protocol",
            .x_label = "depth [mm]",
            .y_label = "force [N]"};
  for (const PressedStimulus& stimulus : pressed) {
    if (plot.panels.empty() || plot.panels.back().title != stimulus.cell)
      plot.panels.push_back({.title = stimulus.cell});
    plot.panels.back().series.push_back(curve_of(stimulus.condition, stimulus.model, stimulus.press));
  }
  add_device_limit(people, plot);
  return plot;
}

}  // namespace palpate::app
