#include "app/commands/check/check.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <memory>
#include <nlohmann/json.hpp>
#include <numeric>
#include <stdexcept>

#include "analysis/report/primary_power.hpp"
#include "analysis/words/words.hpp"
#include "app/command_line/input_kind.hpp"
#include "app/command_line/output.hpp"
#include "app/command_line/scene_options.hpp"
#include "app/command_line/user_cache.hpp"
#include "app/commands/mesh/mesh_report.hpp"
#include "app/study/study_plan.hpp"
#include "app/study/study_table.hpp"
#include "base/text/quantity.hpp"
#include "sim/compile/compile.hpp"
#include "sim/cycle/press.hpp"
#include "sim/effects/effects.hpp"
#include "sim/mesh/quality.hpp"
#include "sim/model/probe_kind.hpp"
#include "trials/protocol/protocol.hpp"
#include "trials/protocol/stimuli.hpp"

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
  sim::Simulation simulation(model);
  const auto probes = sim::displaced_by(model, model.probes.front().depth);
  std::vector<double> times;
  for (int i = 0; i < 2000; ++i) {
    const auto before = std::chrono::steady_clock::now();
    simulation.step(probes, sim::kCyclePeriod);
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

constexpr double kLocking = 0.45;     // Poisson's ratio from which on locking shows
constexpr std::size_t kPadNodes = 3;  // fewer are no area

struct EffectCheck {
  std::string_view name;
  sim::EffectState state{};
  double cycle_us = 0.0;  // what it adds to a cycle
};

struct SceneCheck {
  std::string name;
  std::vector<BodyCheck> bodies{};
  std::vector<EffectCheck> effects{};
  double deformation_us = 0.0;  // a cycle without any effect
};

/// What can be computed and will mislead.
void add_warnings(const sim::Model& model, std::vector<BodyCheck>& checks) {
  for (std::size_t i = 0; i < checks.size(); ++i) {
    sim::MeshQuality& quality = checks[i].quality;
    for (const sim::Material& material : model.bodies[i].materials)
      if (material.poisson_ratio >= kLocking) {
        quality.warnings.push_back(fmt::format(
            "poisson_ratio {}: linear tetrahedra lock as it nears 0.5, and forces come out too large; this "
            "version has no treatment of near-incompressibility",
            material.poisson_ratio));
        break;
      }
    const double size = (quality.upper - quality.lower).norm();
    for (const int probe : model.bodies[i].probes) {
      const sim::Probe& finger = model.probes[probe];
      if (finger.depth > size)
        quality.warnings.push_back(fmt::format("probes.{} presses {:g} mm deep into a body {:g} mm across",
                                               finger.name, 1e3 * finger.depth, 1e3 * size));
      if (finger.kind->keys.takes_radius && finger.nodes.size() < kPadNodes)
        quality.warnings.push_back(fmt::format(
            "probes.{}: its radius reaches no more than {} of the mesh, so that the {} acts as a "
            "point; accepted without warning: a radius of two edges or more",
            finger.name, analysis::counted(static_cast<long>(finger.nodes.size()), "node", "nodes"),
            finger.kind->keys.name));
    }
  }
}

SceneCheck check_scene(const SceneOptions& input) {
  const sim::Scene scene = load_scene(input);
  sim::ComplianceCache cache = user_cache();
  const sim::Model model = sim::compile(scene, cache);
  sim::require_solved(sim::press(model, model.probes.front().depth, 1));
  SceneCheck check{.name = scene.name};
  for (const sim::Body& body : model.bodies)
    check.bodies.push_back(
        {body.name, sim::measure_quality(*body.mesh), body.fixed.size(), body.colliding_nodes.size()});
  add_warnings(model, check.bodies);
  const double whole = median_cycle_us(model);
  sim::Model bare = model;
  for (const sim::Effect* effect : sim::effects()) {
    EffectCheck found{.name = effect->name, .state = effect->state(scene)};
    if (found.state.on) {
      bare = effect->without(std::move(bare));
      found.cycle_us = std::max(0.0, whole - median_cycle_us(effect->without(model)));
    }
    check.effects.push_back(std::move(found));
  }
  check.deformation_us = median_cycle_us(bare);
  return check;
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
  for (const EffectCheck& effect : check.effects)
    fmt::print("  {:<25}{:<5}{:>13}  {}\n", effect.name, effect.state.on ? "on" : "off",
               effect.state.on ? fmt::format("{:.1f}", effect.cycle_us) : "0", effect.state.reason);
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
  for (const EffectCheck& effect : check.effects)
    effects.push_back({{"effect", std::string(effect.name)},
                       {"on", effect.state.on},
                       {"why", effect.state.reason},
                       {"cycle_us", effect.cycle_us}});
  return {{"scene", check.name}, {"bodies", bodies}, {"effects", effects}};
}

// ---- a protocol ----

struct ProtocolCheck {
  trials::Protocol protocol{};
  trials::PlanSummary plan{};
  StudyPlan regions{};
  analysis::Power power{};  // when an effect of middling size is there
};

/// Reads everything that a session will need, so that what is sound here also runs.
ProtocolCheck check_protocol(const std::string& file) {
  ProtocolCheck check{.protocol = trials::load_protocol(file)};
  sim::ComplianceCache cache = user_cache();
  trials::compile_stimuli(check.protocol, cache);
  check.plan = trials::describe(check.protocol);
  check.regions = planned_regions(check.protocol);
  const double certain = check.protocol.analysis.side == trials::Side::Less ? 0.0 : 1.0;
  const double half_way = 0.5 * (check.protocol.task->chance + certain);
  check.power = analysis::primary_power(design_of(check.protocol), half_way);
  return check;
}

/// "37 or more correct of 60 in a cell"
std::string region_in_words(const analysis::CriticalNumber& critical) {
  std::string numbers;
  if (critical.at_least) numbers += fmt::format("{} or more", *critical.at_least);
  if (critical.at_least && critical.at_most) numbers += ", or ";
  if (critical.at_most) numbers += fmt::format("{} or fewer", *critical.at_most);
  if (numbers.empty())
    return fmt::format("none: {} trials in a cell are too few to reject guessing", critical.trials);
  return fmt::format("{} correct of {} in a cell", numbers, critical.trials);
}

void print_regions(const ProtocolCheck& check) {
  const StudyPlan& regions = check.regions;
  if (!regions.critical)
    fmt::print("  critical value  depends on how often either interval is answered; it is in the report\n");
  else if (regions.looks.empty())
    fmt::print("  critical value  {} (size {:.4f})\n", region_in_words(*regions.critical),
               regions.critical->size);
  for (const analysis::PlannedLook& look : regions.looks)
    fmt::print("  critical value  at {} examinees: {} (size by then {:.4f})\n",
               look.critical.trials / check.protocol.trials_per_examinee_per_cell,
               region_in_words(look.critical), look.size);
}

void print_text(const ProtocolCheck& check) {
  const trials::PlanSummary& plan = check.plan;
  fmt::print("{}: a sound protocol\n\n", check.protocol.name);
  fmt::print("  question        {}\n", check.protocol.question);
  const trials::Task& task = *check.protocol.task;
  fmt::print("  task            {}, {}\n", task.name, task.question_in_words(check.protocol));
  fmt::print("  cells           {}\n", fmt::join(plan.cells, ", "));
  fmt::print("  trials          {} an examinee, {} examinees planned: {} in each cell\n",
             plan.trials_per_session, plan.planned_examinees, plan.trials_per_cell);
  fmt::print("{}", analysis::wrapped(plan.order, "  order           ", "                  "));
  fmt::print("  predictability  the best rule that feels nothing is right in {:.0f} % of trials\n",
             100 * plan.best_guess);
  fmt::print("  primary test    {}, {}, alpha {}\n", to_string(check.protocol.analysis.primary),
             to_string(check.protocol.analysis.side), check.protocol.analysis.alpha);
  print_regions(check);
  fmt::print("  power           {:.4f} when {:.0f} % of answers are correct ({})\n", check.power.power,
             100 * check.power.probability,
             check.power.studies > 0 ? fmt::format("{} simulated studies", check.power.studies) : "exact");
}

ordered_json critical_json(const analysis::CriticalNumber& critical, double size) {
  ordered_json json = {{"trials", critical.trials}, {"size", size}};
  if (critical.at_least) json["at_least"] = *critical.at_least;
  if (critical.at_most) json["at_most"] = *critical.at_most;
  return json;
}

ordered_json to_json(const ProtocolCheck& check) {
  const StudyPlan& regions = check.regions;
  ordered_json looks = ordered_json::array(), critical;  // null where it depends on the answers
  for (const analysis::PlannedLook& look : regions.looks)
    looks.push_back(critical_json(look.critical, look.size));
  if (regions.critical)
    critical = critical_json(*regions.critical,
                             regions.looks.empty() ? regions.critical->size : regions.looks.back().size);
  return {{"protocol", check.protocol.name},
          {"sha256", check.protocol.sha256},
          {"trials_per_examinee", check.plan.trials_per_session},
          {"planned_examinees", check.plan.planned_examinees},
          {"trials_per_cell", check.plan.trials_per_cell},
          {"cells", check.plan.cells},
          {"order", check.plan.order},
          {"best_guess", check.plan.best_guess},
          {"primary", to_string(check.protocol.analysis.primary)},
          {"alpha", check.protocol.analysis.alpha},
          {"side", to_string(check.protocol.analysis.side)},
          {"critical", critical},
          {"looks", looks},
          {"power",
           {{"probability", check.power.probability},
            {"power", check.power.power},
            {"simulated_studies", check.power.studies}}}};
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
  const MeshReport report = inspect_mesh(options.input.file, base::metres_per_unit(options.unit));
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

void add_check(CLI::App& command) {
  auto options = std::make_shared<CheckOptions>();
  add_scene(command, options->input);
  command.get_option("scene")->description("Protocol or scene (TOML), or mesh (MSH, VTU)");
  command.add_option("--unit", options->unit, "Unit of a mesh file's coordinates: m, cm, mm or um");
  add_format(command, options->format);
  command.footer(
      "Examples:\n  palpate check protocols/kuroda2003.toml\n  palpate check "
      "data/scenes/rectal-palpation.toml\n"
      "  palpate check prostate.msh --unit mm");
  command.callback([options] { run_check(*options); });
}

}  // namespace

const Command check_command{.name = "check",
                            .summary = "Validates a protocol, a scene or a mesh, and says what it amounts to",
                            .heading = "Run a study",
                            .add = add_check};

}  // namespace palpate::app
