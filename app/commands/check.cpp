#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <memory>
#include <nlohmann/json.hpp>
#include <numeric>
#include <stdexcept>

#include "analysis/statistics/binomial_power.hpp"
#include "analysis/statistics/critical_number.hpp"
#include "analysis/words.hpp"
#include "app/commands/commands.hpp"
#include "app/input_kind.hpp"
#include "app/mesh_report.hpp"
#include "app/output.hpp"
#include "app/scene_options.hpp"
#include "app/user_cache.hpp"
#include "sim/cycle/press.hpp"
#include "sim/mesh/quality.hpp"
#include "sim/scene/effects.hpp"
#include "sim/scene/quantity.hpp"
#include "trials/protocol.hpp"

namespace palpate::app {
namespace {

using nlohmann::ordered_json;

struct CheckOptions {
  SceneOptions input{};
  std::string unit;
  std::string format;
};

// ---- a scene ----

/// Median time of a cycle at full depth [microseconds], over cycles enough for a stable median.
double median_cycle_us(const sim::Model& model) {
  sim::Scratch scratch(model);
  const auto pose = sim::pose_at_depth(model, model.probes.front().depth);
  std::vector<double> times;
  for (int i = 0; i < 2000; ++i) {
    const auto before = std::chrono::steady_clock::now();
    sim::cycle(model, {}, pose, scratch);
    times.push_back(
        std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - before).count());
  }
  std::ranges::nth_element(times, times.begin() + 1000);
  return times[1000];
}

struct BodyCheck {
  std::string name;
  sim::MeshQuality quality{};
  std::size_t fixed = 0, can_collide = 0;
};

struct SceneCheck {
  std::string name;
  std::vector<BodyCheck> bodies{};
  std::vector<sim::Effect> effects{};
  double deformation_us = 0.0;  // a cycle without contact
  double contact_us = 0.0;      // what contact adds
};

SceneCheck check_scene(const SceneOptions& input) {
  const sim::Scene scene = load_scene(input);
  sim::ComplianceCache cache = user_cache();
  sim::Model model = sim::compile(scene, cache);
  SceneCheck check{.name = scene.name, .effects = sim::effects_of(scene)};
  for (const sim::Body& body : model.bodies)
    check.bodies.push_back(
        {body.name, sim::measure_quality(*body.mesh), body.fixed.size(), body.colliding_nodes.size()});
  const double whole = median_cycle_us(model);
  model.law = sim::ContactModel::None;
  check.deformation_us = median_cycle_us(model);
  check.contact_us = std::max(0.0, whole - check.deformation_us);
  return check;
}

std::string cost_of(const SceneCheck& check, const sim::Effect& effect) {
  if (!effect.on) return "0";
  return fmt::format("{:.1f}", effect.name == "contact" ? check.contact_us : 0.0);
}

void print_text(const SceneCheck& check) {
  fmt::print("{}: a sound scene\n\nbodies\n", check.name);
  for (const BodyCheck& body : check.bodies) {
    const sim::MeshQuality& q = body.quality;
    fmt::print("  {}: {} nodes ({} of the surface, {} fixed, {} can collide), {} tetrahedra\n", body.name,
               q.nodes, q.surface_nodes, body.fixed, body.can_collide, q.tetrahedra);
    fmt::print(
        "    dihedral angles {:.1f} to {:.1f} degrees, radius ratio {:.2f} at worst, {:.2f} on average\n",
        q.min_dihedral, q.max_dihedral, q.min_radius_ratio, q.mean_radius_ratio);
    for (const std::string& warning : q.warnings) fmt::print("    warning: {}\n", warning);
  }
  fmt::print("\n{:<27}{:<5}{:>13}  {}\n", "effects", "", "us a cycle", "why");
  fmt::print("  {:<25}{:<5}{:>13.1f}  {}\n", "linear elasticity", "on", check.deformation_us, "every scene");
  for (const sim::Effect& effect : check.effects)
    fmt::print("  {:<25}{:<5}{:>13}  {}\n", effect.name, effect.on ? "on" : "off", cost_of(check, effect),
               effect.reason);
  fmt::print("\nMedian times on this machine, probes at their full depth.\n");
}

ordered_json to_json(const SceneCheck& check) {
  ordered_json bodies, effects = ordered_json::array();
  for (const BodyCheck& body : check.bodies)
    bodies[body.name] = {{"nodes", body.quality.nodes},
                         {"surface_nodes", body.quality.surface_nodes},
                         {"fixed_nodes", body.fixed},
                         {"colliding_nodes", body.can_collide},
                         {"tetrahedra", body.quality.tetrahedra},
                         {"min_dihedral_degree", body.quality.min_dihedral},
                         {"min_radius_ratio", body.quality.min_radius_ratio},
                         {"warnings", body.quality.warnings}};
  effects.push_back({{"effect", "linear elasticity"},
                     {"on", true},
                     {"why", "every scene"},
                     {"cycle_us", check.deformation_us}});
  for (const sim::Effect& effect : check.effects)
    effects.push_back({{"effect", effect.name},
                       {"on", effect.on},
                       {"why", effect.reason},
                       {"cycle_us", effect.on ? check.contact_us : 0.0}});
  return {{"scene", check.name}, {"bodies", bodies}, {"effects", effects}};
}

// ---- a protocol ----

struct ProtocolCheck {
  trials::Protocol protocol{};
  trials::PlanSummary plan{};
  analysis::CriticalNumber critical{};
  double power = 0.0;  // when 3 of 4 answers are correct
};

constexpr double kProbabilityOfAnEffect = 0.75;  // half way between chance and certainty

ProtocolCheck check_protocol(const std::string& file) {
  ProtocolCheck check{.protocol = trials::load_protocol(file)};
  check.plan = trials::describe(check.protocol);
  const double chance = 1.0 / trials::intervals_per_trial(check.protocol);
  const analysis::Side side = analysis::side_from_name(check.protocol.analysis.side);
  check.critical =
      analysis::critical_number(check.plan.trials_per_cell, chance, check.protocol.analysis.alpha, side);
  check.power = analysis::rejection_probability(check.critical, kProbabilityOfAnEffect);
  return check;
}

void print_text(const ProtocolCheck& check) {
  const trials::PlanSummary& plan = check.plan;
  fmt::print("{}: a sound protocol\n\n", check.protocol.name);
  fmt::print("  question        {}\n", check.protocol.question);
  fmt::print("  task            {}, {} against {}; \"{}\" is correct\n", check.protocol.task,
             check.protocol.conditions[check.protocol.pair[0]].name,
             check.protocol.conditions[check.protocol.pair[1]].name,
             check.protocol.conditions[check.protocol.correct].name);
  fmt::print("  cells           {}\n", fmt::join(plan.cells, ", "));
  fmt::print("  trials          {} an examinee, {} examinees planned: {} in each cell\n",
             plan.trials_per_session, plan.planned_examinees, plan.trials_per_cell);
  fmt::print("{}", analysis::wrapped(plan.order, "  order           ", "                  "));
  fmt::print("  predictability  the best rule that feels nothing is right in {:.0f} % of trials\n",
             100 * plan.best_guess);
  fmt::print("  primary test    {}, {}, alpha {}\n", check.protocol.analysis.primary,
             check.protocol.analysis.side, check.protocol.analysis.alpha);
  if (check.critical.at_least)
    fmt::print("  critical value  {} or more correct of {} in a cell (size {:.4f})\n",
               *check.critical.at_least, plan.trials_per_cell, check.critical.size);
  if (check.critical.at_most)
    fmt::print("  critical value  {} or fewer correct of {} in a cell\n", *check.critical.at_most,
               plan.trials_per_cell);
  fmt::print("  power           {:.4f} when {:.0f} % of answers are correct (exact)\n", check.power,
             100 * kProbabilityOfAnEffect);
}

ordered_json to_json(const ProtocolCheck& check) {
  ordered_json critical = {{"size", check.critical.size}};
  if (check.critical.at_least) critical["at_least"] = *check.critical.at_least;
  if (check.critical.at_most) critical["at_most"] = *check.critical.at_most;
  return {{"protocol", check.protocol.name},
          {"sha256", check.protocol.sha256},
          {"trials_per_examinee", check.plan.trials_per_session},
          {"planned_examinees", check.plan.planned_examinees},
          {"trials_per_cell", check.plan.trials_per_cell},
          {"cells", check.plan.cells},
          {"order", check.plan.order},
          {"best_guess", check.plan.best_guess},
          {"primary", check.protocol.analysis.primary},
          {"alpha", check.protocol.analysis.alpha},
          {"side", check.protocol.analysis.side},
          {"critical", critical},
          {"power", {{"probability", kProbabilityOfAnEffect}, {"power", check.power}}}};
}

// ---- which of the three it is ----

template <typename Check>
void print(const Check& check, const std::string& format) {
  if (format == "json")
    print_json(to_json(check));
  else
    print_text(check);
}

void check_mesh(const CheckOptions& options) {
  if (options.unit.empty())
    throw std::invalid_argument(fmt::format(
        "{}: a mesh file does not name its unit; give --unit m, cm, mm or um", options.input.file));
  const MeshReport report = inspect_mesh(options.input.file, sim::metres_per_unit(options.unit));
  if (options.format == "json")
    print_json(to_json(report));
  else
    fmt::print("{}", to_text(report));
}

void run_check(const CheckOptions& options) {
  const std::string ending = std::filesystem::path(options.input.file).extension();
  if (ending == ".msh" || ending == ".vtu") return check_mesh(options);
  if (input_kind(options.input) == InputKind::Scene) return print(check_scene(options.input), options.format);
  print(check_protocol(options.input.file), options.format);
}

}  // namespace

void add_check(CLI::App& app) {
  auto options = std::make_shared<CheckOptions>();
  CLI::App* command =
      app.add_subcommand("check", "Validates a protocol, a scene or a mesh, and says what it amounts to");
  add_scene(*command, options->input);
  command->get_option("scene")->description("Protocol or scene (TOML), or mesh (MSH, VTU)");
  command->add_option("--unit", options->unit, "Unit of a mesh file's coordinates: m, cm, mm or um");
  add_format(*command, options->format);
  command->footer(
      "Examples:\n  palpate check protocols/kuroda2003.toml\n  palpate check "
      "data/scenes/rectal-palpation.toml\n"
      "  palpate check prostate.msh --unit mm");
  command->callback([options] { run_check(*options); });
}

}  // namespace palpate::app
