#include "app/commands/cost/sweep_output.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "app/commands/cost/sweep_state.hpp"
#include "base/text/csv.hpp"

namespace palpate::app {
namespace {

using nlohmann::ordered_json;

/// The meshes of a variant by their files' names.
std::string meshes_of(const Sweep& sweep, const sim::Variant& variant) {
  std::vector<std::string> names;
  for (const sim::BodySpec& body : sim::with_variant(sweep.scene, variant).bodies)
    if (body.present) names.push_back(body.mesh.stem().string());
  return fmt::format("{}", fmt::join(names, ", "));
}

std::string mesh_text(const Sweep& sweep, const sim::Variant& variant) {
  const int meshes = sim::has_mesh_limit(sweep.scene) ? sim::meshes_of(sweep.scene) : 1;
  return fmt::format("{}/{}", variant.mesh + 1, meshes);
}

ordered_json variant_json(const Sweep& sweep, std::size_t i) {
  const sim::ForceErrors& errors = sweep.errors[i];
  ordered_json json = result_json(sweep.variants[i]);
  json["refinement"] = sweep.variants[i].variant.mesh;
  json["mesh"] = meshes_of(sweep, sweep.variants[i].variant);
  json["name"] = name_in_sweep(sweep, sweep.variants[i]);
  json["on_front"] = errors.on_front;
  json["force_error"] = errors.whole;
  json["parts"] = {
      {"discretisation", nullptr}, {"contact_model", errors.contact_model}, {"solver", errors.solver}};
  if (errors.discretisation) json["parts"]["discretisation"] = *errors.discretisation;
  return json;
}

ordered_json name_or_null(const Sweep& sweep, const std::optional<std::size_t>& i) {
  return i ? ordered_json(name_in_sweep(sweep, sweep.variants[*i])) : ordered_json(nullptr);
}

/// A share as per cent, "-" where there is none.
std::string percent(const std::optional<double>& share) {
  if (!share) return "-";
  return *share == 0.0 ? "0" : fmt::format("{:.3g}", 100 * *share);
}

std::string accuracy_table(const Sweep& sweep) {
  std::string text = fmt::format("{:<38} {:>4} {:>7} {:>7} {:>7} {:>8} {:>7} {:>8} {:>7} {:>8}\n", "", "",
                                 "force", "of it:", "contact", "", "displ.", "overlap", "imbal.", "jump");
  text += fmt::format("{:<38} {:>4} {:>7} {:>7} {:>7} {:>8} {:>7} {:>8} {:>7} {:>8}\n", "variant", "mesh",
                      "[%]", "mesh", "model", "solver", "[%]", "[mm]", "[%]", "[N]");
  for (std::size_t i = 0; i < sweep.variants.size(); ++i) {
    const sim::VariantResult& result = sweep.variants[i];
    const sim::ForceErrors& errors = sweep.errors[i];
    text += fmt::format("{:<38} {:>4} {:>7} {:>7} {:>7} {:>8} {:>7} {:>8.2g} {:>7.2g} {:>8.2g}{}\n",
                        sim::name_of(result.variant), mesh_text(sweep, result.variant), percent(errors.whole),
                        percent(errors.discretisation), percent(errors.contact_model), percent(errors.solver),
                        percent(result.displacement_error), 1e3 * result.penetration, 100 * result.imbalance,
                        result.largest_jump,
                        result.unsolved > 0 ? fmt::format("  {} unsolved", result.unsolved) : "");
  }
  return text;
}

std::string time_table(const Sweep& sweep) {
  std::string text =
      fmt::format("{:<38} {:>4} {:>6} {:>16} {:>8} {:>8} {:>8} {:>8} {:>9} {:>7}\n", "variant", "mesh",
                  "nodes", "median [us]", "p99", "p99.9", "slowest", "first", "prepare s", "MB");
  for (std::size_t i = 0; i < sweep.variants.size(); ++i) {
    const sim::VariantResult& result = sweep.variants[i];
    const auto [least, most] = std::ranges::minmax(result.rounds);
    text += fmt::format("{:<38} {:>4} {:>6} {:>16} {:>8.3g} {:>8.3g} {:>8.3g} {:>8.3g} {:>9.2f} {:>7.1f}{}\n",
                        sim::name_of(result.variant), mesh_text(sweep, result.variant), result.nodes,
                        fmt::format("{:.3g} ({:.3g}-{:.3g})", result.time.median, least, most),
                        result.time.p99, result.time.p999, result.time.slowest, result.first, result.prepare,
                        1e-6 * static_cast<double>(result.bytes), sweep.errors[i].on_front ? "  *" : "");
  }
  return text;
}

/// What is drawn as one curve over the meshes.
std::string curve_of(const sim::Variant& variant) {
  return sim::name_of(variant);
}

constexpr double kLeastDrawn = 1e-6;  // of an error [%]: what is below is drawn there

}  // namespace

ordered_json sweep_json(const Sweep& sweep) {
  ordered_json variants = ordered_json::array();
  for (std::size_t i = 0; i < sweep.variants.size(); ++i) variants.push_back(variant_json(sweep, i));
  ordered_json reference = {{"force", sweep.reference.forces.back()},
                            {"curve", sweep.reference.forces},
                            {"uncertainty", nullptr},
                            {"displacement_uncertainty", nullptr},
                            {"converges", sweep.reference.converges},
                            {"how", reference_in_words(sweep)}};
  if (sim::has_mesh_limit(sweep.scene)) reference["uncertainty"] = sweep.reference.uncertainty;
  if (sweep.displacement_uncertainty) reference["displacement_uncertainty"] = *sweep.displacement_uncertainty;
  return {{"reference", reference},
          {"band",
           {{"lower", sweep.plan.band.lower},
            {"upper", sweep.plan.band.upper},
            {"source", sweep.plan.band_source}}},
          {"variants", variants},
          {"advice",
           {{"cheapest_unfelt", name_or_null(sweep, sweep.advice.cheapest_unfelt)},
            {"most_accurate_at_rate", name_or_null(sweep, sweep.advice.most_accurate_in_time)},
            {"sentence", advice_in_words(sweep)}}}};
}

std::string sweep_text(const Sweep& sweep) {
  std::string text = fmt::format("\nWhat accuracy costs: a press of {:g} mm\nReference: {}",
                                 1e3 * sweep.plan.depth, reference_in_words(sweep));
  if (sim::has_mesh_limit(sweep.scene) && sweep.reference.converges)
    text += fmt::format("; known to {:.2g} % of the force", 100 * sweep.reference.uncertainty);
  text +=
      "\n\n" + accuracy_table(sweep) +
      "\nforce: error of the force curve, root mean square over the press; displ.: likewise of the touched surfaces "
      "at its end;\noverlap, imbalance of action and reaction, and jump of the force within 1 um: the largest of the "
      "press\n\n" +
      time_table(sweep) +
      "\nmedian: of a warm cycle, in brackets the medians of single rounds; first: of a fresh simulation; *: on the "
      "front, none is both faster and more accurate\n\n" +
      advice_in_words(sweep) + "\n";
  return text;
}

std::string sweep_csv(const Sweep& sweep, const std::string& machine, const std::string& versions) {
  std::vector<std::vector<std::string>> rows{{"model",
                                              "friction",
                                              "tolerance",
                                              "refinement",
                                              "mesh",
                                              "interior",
                                              "precision",
                                              "nodes",
                                              "touchable_nodes",
                                              "edge_m",
                                              "force_error",
                                              "discretisation_error",
                                              "contact_model_error",
                                              "solver_error",
                                              "displacement_error",
                                              "penetration_m",
                                              "imbalance",
                                              "largest_jump_n",
                                              "force_error_bound_n",
                                              "unsolved",
                                              "median_us",
                                              "median_least_us",
                                              "median_most_us",
                                              "p99_us",
                                              "p99_9_us",
                                              "slowest_us",
                                              "first_us",
                                              "prepare_s",
                                              "memory_bytes",
                                              "on_front",
                                              "machine",
                                              "versions"}};
  const auto number = [](const std::optional<double>& value) {
    return value && std::isfinite(*value) ? fmt::format("{:.9g}", *value) : std::string();
  };
  for (std::size_t i = 0; i < sweep.variants.size(); ++i) {
    const sim::VariantResult& result = sweep.variants[i];
    const sim::Variant& variant = result.variant;
    const sim::ForceErrors& errors = sweep.errors[i];
    const auto [least, most] = std::ranges::minmax(result.rounds);
    rows.push_back({variant.model,
                    variant.friction ? "1" : "0",
                    number(variant.tolerance),
                    std::to_string(variant.mesh),
                    meshes_of(sweep, variant),
                    std::to_string(variant.interior),
                    std::string(base::word_of(sim::kPrecisionWords, variant.precision)),
                    std::to_string(result.nodes),
                    std::to_string(result.touchable),
                    number(result.edge),
                    number(errors.whole),
                    number(errors.discretisation),
                    number(errors.contact_model),
                    number(errors.solver),
                    number(result.displacement_error),
                    number(result.penetration),
                    number(result.imbalance),
                    number(result.largest_jump),
                    number(result.force_error_bound),
                    std::to_string(result.unsolved),
                    number(result.time.median),
                    number(least),
                    number(most),
                    number(result.time.p99),
                    number(result.time.p999),
                    number(result.time.slowest),
                    number(result.first),
                    number(result.prepare),
                    std::to_string(result.bytes),
                    errors.on_front ? "1" : "0",
                    machine,
                    versions});
  }
  std::string text;
  for (const auto& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i) text += (i > 0 ? "," : "") + base::csv_field(row[i]);
    text += '\n';
  }
  return text;
}

Plot work_precision(const Sweep& sweep, const std::string& note) {
  Plot plot{.title = fmt::format("What accuracy costs in time: {}", sweep.scene.name),
            .note = fmt::format(
                "a press of {:g} mm; error of the force curve against: {}; curves run over the meshes; {}",
                1e3 * sweep.plan.depth, reference_in_words(sweep), note),
            .x_label = "error of the force [%]",
            .y_label = "median time of a cycle [µs]",
            .log_x = true,
            .log_y = true,
            .panels = {{}},
            .limits = {{"1 kHz", 1e3}, {"250 Hz, as the paper has it", 4e3}},
            .bands = {{"a finger just tells", 100 * sweep.plan.band.lower, 100 * sweep.plan.band.upper}}};
  std::vector<PlotSeries>& series = plot.panels.front().series;
  PlotSeries front{.name = "front: none is both faster and more accurate"};
  std::vector<std::pair<double, double>> on_front;
  for (std::size_t i = 0; i < sweep.variants.size(); ++i) {
    const double error = std::max(kLeastDrawn, 100 * sweep.errors[i].whole),
                 time = sweep.variants[i].time.median;
    if (sweep.errors[i].on_front) on_front.emplace_back(error, time);
    const std::string name = curve_of(sweep.variants[i].variant);
    auto found = std::ranges::find(series, name, &PlotSeries::name);
    if (found == series.end()) found = series.insert(series.end(), {.name = name});
    found->x.push_back(error);
    found->y.push_back(time);
  }
  std::ranges::sort(on_front);
  for (const auto& [error, time] : on_front) {
    front.x.push_back(error);
    front.y.push_back(time);
  }
  series.push_back(std::move(front));
  return plot;
}

Plot over_family(const Sweep& sweep, const std::string& note) {
  Plot plot{.title = fmt::format("One haptic cycle over the size of the meshes: {}", sweep.scene.name),
            .note = fmt::format(
                "median, shaded up to the time that 99.9 % of the cycles keep; Fig. 5 of Kuroda et al. "
                "2003 is this picture for their model; {}",
                note),
            .x_label = "nodes of all bodies",
            .y_label = "time of a cycle [µs]",
            .log_x = true,
            .log_y = true,
            .panels = {{}},
            .limits = {{"1 kHz", 1e3}}};
  std::vector<PlotSeries>& series = plot.panels.front().series;
  for (const sim::VariantResult& result : sweep.variants) {
    const sim::Variant& variant = result.variant;
    if (variant.tolerance > 0.0 || variant.interior > 0 || variant.precision == sim::Precision::Single)
      continue;
    const std::string name = sim::name_of(variant);
    auto found = std::ranges::find(series, name, &PlotSeries::name);
    if (found == series.end()) found = series.insert(series.end(), {.name = name});
    found->x.push_back(result.nodes);
    found->y.push_back(result.time.median);
    found->high.push_back(result.time.p999);
  }
  return plot;
}

}  // namespace palpate::app
