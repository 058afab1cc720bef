#pragma once

#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "sim/cycle/simulation.hpp"
#include "tests/hard_cases/hard_case.hpp"

namespace palpate::hard_cases {

/// A body of a scene file.
struct BodyOf {
  std::string name{};
  TetMesh mesh{};
  std::string fixed = "\"z_min\"", touchable = "\"z_max\"";  // as the file has them
  double modulus = 1e6;                                      // E [Pa]
  Vec3 offset = Vec3::Zero();                                // [m]
  std::string unit = "m";                                    // of its mesh file
};

inline constexpr const char* kPad = "kind = \"pad\"\nradius = \"6 mm\"";

/// A probe of a scene file.
struct ProbeOf {
  std::string name = "finger";
  std::string body = "upper";
  std::string kind = kPad;
  Vec3 at = Vec3::Zero();
  Vec3 direction = -Vec3::UnitZ();
};

struct SceneOf {
  std::vector<BodyOf> bodies{};
  std::vector<ProbeOf> probes{};
  std::string contact{};  // further keys of the contact table
  std::string touch = "[[\"upper\", \"lower\"]]";
};

/// Writes a scene and its meshes into a folder of its own, gone with the process, and gives the file.
std::filesystem::path write_scene(const SceneOf& scene);
/// The same, compiled for a contact model, without a cache on disk.
sim::Model compiled(const SceneOf& scene, std::string_view model, std::span<const sim::Override> more = {});
sim::Model compiled(const std::filesystem::path& file, std::string_view model,
                    std::span<const sim::Override> more = {});

/// What compiling a scene was refused with; "" where it was not.
std::string refusal_of(const std::filesystem::path& file, std::span<const sim::Override> overrides);

/// Where two boxes lie: the upper one, 30 x 30 x 5 mm, held at its sides, over a block of 20 mm on a fixed bottom.
struct Boxes {
  int upper_cells = 6, lower_cells = 7;  // along x and y; the pad presses a node where the upper one is even
  double gap = 0.2e-3;                   // [m]
  double shift = 1.7e-3;                 // of the upper box along x and y, so that nodes face no nodes [m]
};
/// Every number of it with jitter; a pad presses the middle of the upper box. `gap` keeps its sign: nodes of the
/// surfaces that face each other move along them only where it is 0.
SceneOf two_boxes(Jitter& jitter, const Boxes& boxes = {});

/// A box whose group "sides" are its four sides.
TetMesh box_with_sides(int cells, int layers, const Vec3& size);

/// One cycle with the first probe there and the others at rest.
sim::CycleResult step_to(sim::Simulation& simulation, const Vec3& there);

/// Force on the first finger after one cycle from a fresh start.
Vec3 force_at(const sim::Model& model, const Vec3& there);

/// Largest eigenvalue of the first probe's stiffness with every candidate contact bilateral [N/m].
double steepest(const sim::Model& exact);

/// Half of the work of all loads along the displacements that they bring [J].
double stored_energy(const sim::Model& model, const sim::Simulation& simulation);

/// |a - b| / |b|.
double apart(const Vec3& a, const Vec3& b);

inline constexpr std::string_view kBalanced[] = {"exact"};
inline constexpr std::string_view kLaws[] = {"exact", "kuroda", "sibille"};

/// The figure of `exact` as the outcome's, those of `kuroda` and `sibille` as published.
template <class Figure>
Outcome of_each_law(double limit, Figure figure, Bound bound = Bound::AtMost) {
  Outcome outcome{.limit = limit, .bound = bound};
  outcome.figure = figure("exact", outcome);
  Outcome unbound;
  outcome.kuroda = figure("kuroda", unbound);
  outcome.sibille = figure("sibille", unbound);
  return outcome;
}

/// The worst figure of all laws: each must keep the limit.
template <class Figure>
Outcome of_all_laws(double limit, Figure figure, Bound bound = Bound::AtMost) {
  std::vector<Outcome> outcomes;
  for (const std::string_view law : kLaws) {
    Outcome& outcome = outcomes.emplace_back(Outcome{.limit = limit, .bound = bound});
    outcome.figure = figure(law, outcome);
    for (std::string& fault : outcome.faults) fault = std::string(law) + ": " + fault;
  }
  return worst(outcomes);
}

}  // namespace palpate::hard_cases
