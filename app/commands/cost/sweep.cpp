#include "app/commands/cost/sweep.hpp"

#include <fmt/format.h>
#include <malloc.h>

#include <algorithm>
#include <chrono>
#include <map>
#include <memory>
#include <utility>

#include "sim/compile/compile.hpp"
#include "sim/cost/family.hpp"
#include "sim/cost/press_accuracy.hpp"
#include "sim/cost/variant_time.hpp"
#include "sim/scene/refuse_key.hpp"

namespace palpate::app {
namespace {

constexpr int kLeastMeshes = 3;  // of an extrapolation

/// Bytes of the heap that are in use.
std::size_t heap_in_use() {
  const struct mallinfo2 all = mallinfo2();
  return all.uordblks + all.hblkhd;
}

/// What a step of the preparation takes.
struct Taken {
  double seconds = 0.0;
  std::size_t bytes = 0;
};

template <class Work>
Taken taken_by(Work work) {
  const std::size_t before = heap_in_use();
  const auto start = std::chrono::steady_clock::now();
  work();
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
  const std::size_t after = heap_in_use();
  return {took.count(), after > before ? after - before : 0};
}

/// One mesh of the family with so many cuts inside: what its variants share.
struct Condensed {
  sim::ComplianceCache cache{""};
  Taken taken{};
};

/// The most accurate solution on the finest mesh: where displacements are compared with.
struct Finest {
  sim::Model model{};
  std::vector<Eigen::VectorXd> displacement{};
};

class Measuring {
 public:
  Measuring(const sim::Scene& scene, const SweepPlan& plan) : scene_(scene), plan_(plan) {
    if (!sim::has_mesh_limit(scene)) return;
    const sim::Variant best = sim::best_of(scene, sim::meshes_of(scene) - 1);
    finest_.model = sim::compile(sim::with_variant(scene, best), condense({best.mesh, best.interior}).cache);
    finest_.displacement =
        sim::measure_accuracy(finest_.model, {.depth = plan.depth, .small_step = plan.depth}).displacement;
  }

  sim::VariantResult measure(const sim::Variant& variant) {
    Condensed& condensed = condense({variant.mesh, variant.interior});
    const sim::Model model = sim::compile(sim::with_variant(scene_, variant), condensed.cache);
    std::unique_ptr<sim::Simulation> simulation;
    const Taken made = taken_by([&] { simulation = std::make_unique<sim::Simulation>(model); });
    simulation.reset();
    const sim::PressAccuracy accuracy = sim::measure_accuracy(model, {.depth = plan_.depth});
    const sim::VariantTime time = sim::measure_time(model, plan_.depth, plan_.seconds);
    sim::VariantResult result{.variant = variant,
                              .edge = sim::edge_of(model),
                              .forces = accuracy.forces,
                              .penetration = accuracy.penetration,
                              .imbalance = accuracy.imbalance,
                              .largest_jump = accuracy.largest_jump,
                              .force_error_bound = accuracy.force_error_bound,
                              .unsolved = accuracy.unsolved,
                              .rounds = time.rounds,
                              .time = time.warm,
                              .first = time.first,
                              .prepare = condensed.taken.seconds + made.seconds,
                              .bytes = condensed.taken.bytes + made.bytes};
    for (const sim::Body& body : model.bodies) {
      result.nodes += static_cast<int>(body.mesh->nodes.size());
      result.touchable += static_cast<int>(body.rest.cols());
    }
    if (!finest_.displacement.empty())
      result.displacement_error =
          sim::displacement_error(model, accuracy.displacement, finest_.model, finest_.displacement);
    return result;
  }

 private:
  Condensed& condense(const std::pair<int, int>& mesh_and_interior) {
    const bool fresh = !condensed_.contains(mesh_and_interior);
    Condensed& condensed = condensed_[mesh_and_interior];
    if (fresh)
      condensed.taken = taken_by([&] {
        const sim::Variant exact = sim::exact_on(scene_, mesh_and_interior.first, mesh_and_interior.second);
        sim::compile(sim::with_variant(scene_, exact), condensed.cache);
      });
    return condensed;
  }

  const sim::Scene& scene_;
  const SweepPlan& plan_;
  std::map<std::pair<int, int>, Condensed> condensed_;
  Finest finest_;
};

const sim::VariantResult& result_of(const Sweep& sweep, const sim::Variant& variant) {
  return *std::ranges::find(sweep.variants, variant, &sim::VariantResult::variant);
}

/// What the force curves are compared with.
void find_reference(Sweep& sweep) {
  if (!sim::has_mesh_limit(sweep.scene)) {
    sweep.reference = {
        .converges = true,
        .forces = result_of(sweep, sim::exact_on(sweep.scene, 0)).forces,
        .how =
            "exact on the same meshes: a point has no limit as meshes become finer, for its force tends to 0; errors "
            "are those of the contact model and of its solver alone"};
    return;
  }
  const int meshes = sim::meshes_of(sweep.scene);
  std::vector<std::vector<double>> curves;
  std::vector<double> edges;
  for (int mesh = 0; mesh < meshes; ++mesh) {
    const sim::VariantResult& best = result_of(sweep, sim::best_of(sweep.scene, mesh));
    curves.push_back(best.forces);
    edges.push_back(best.edge);
  }
  if (meshes < kLeastMeshes) {
    sweep.reference = {
        .forces = curves.back(),
        .how = fmt::format("exact on the finest meshes, cut finer inside: a limit needs {} refinements "
                           "or more of each body, and the scene names {} (bodies.NAME.refinements)",
                           kLeastMeshes - 1, meshes - 1)};
    return;
  }
  sweep.reference = sim::extrapolate(curves, edges);
  sweep.displacement_uncertainty = result_of(sweep, sim::best_of(sweep.scene, meshes - 2)).displacement_error;
}

}  // namespace

Sweep run_sweep(const sim::Scene& scene, const SweepPlan& plan, std::vector<sim::VariantResult> finished,
                const std::function<void(const std::vector<sim::VariantResult>&, std::size_t)>& progress) {
  sim::with_place(scene, [&] {
    sim::meshes_of(scene);
    if (sim::has_mesh_limit(scene)) sim::require_one_body(scene);
  });
  Sweep sweep{.scene = scene, .plan = plan, .variants = std::move(finished)};
  std::vector<sim::Variant> all = sim::variants_of(scene);
  if (!plan.model.empty())
    std::erase_if(all, [&](const sim::Variant& variant) {
      return variant.model != plan.model && variant.model != "exact";
    });
  Measuring measuring(sweep.scene, sweep.plan);
  for (std::size_t i = sweep.variants.size(); i < all.size(); ++i) {
    sweep.variants.push_back(measuring.measure(all[i]));
    progress(sweep.variants, all.size());
  }
  find_reference(sweep);
  sweep.errors = sim::errors_of(sweep.scene, sweep.variants, sweep.reference.forces);
  sweep.advice = sim::advise(sweep.variants, sweep.errors, sweep.reference, plan.band, plan.period);
  return sweep;
}

std::string reference_in_words(const Sweep& sweep) {
  return sweep.reference.how;
}

std::string name_in_sweep(const Sweep& sweep, const sim::VariantResult& result) {
  std::string name = sim::name_of(result.variant);
  const int meshes = sim::has_mesh_limit(sweep.scene) ? sim::meshes_of(sweep.scene) : 1;
  if (meshes > 1) name += fmt::format(", mesh {} of {}", result.variant.mesh + 1, meshes);
  return name;
}

std::string advice_in_words(const Sweep& sweep) {
  const auto& [cheapest, accurate, refused] = sweep.advice;
  if (!refused.empty()) return fmt::format("No advice: {}.", refused);
  const auto told = [&](std::size_t i) {
    return fmt::format("{} ({:.2g} % of the force, {:.3g} us a cycle)",
                       name_in_sweep(sweep, sweep.variants[i]), 100 * sweep.errors[i].whole,
                       sweep.variants[i].time.median);
  };
  const std::string felt = fmt::format("{:.2g} % of the force", 100 * sweep.plan.band.lower);
  const std::string rate = fmt::format("{:g} kHz", 1e3 / sweep.plan.period);
  if (!cheapest && !accurate)
    return fmt::format("No variant keeps {} in 99.9 % of its cycles, or is within {}.", rate, felt);
  if (!cheapest)
    return fmt::format(
        "No variant is within what a finger tells apart ({}); the most accurate that keeps {} is {}.", felt,
        rate, told(*accurate));
  if (!accurate)
    return fmt::format("The cheapest whose error a finger does not tell ({}) is {}; none keeps {}.", felt,
                       told(*cheapest), rate);
  if (*cheapest == *accurate)
    return fmt::format(
        "{} is the cheapest whose error a finger does not tell ({}), and the most accurate that keeps {}.",
        told(*cheapest), felt, rate);
  return fmt::format(
      "The cheapest whose error a finger does not tell ({}) is {}; the most accurate that keeps {} is {}.",
      felt, told(*cheapest), rate, told(*accurate));
}

}  // namespace palpate::app
