#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/command_line/plot.hpp"
#include "sim/cost/cycle_cost.hpp"
#include "sim/cost/tolerance_cost.hpp"
#include "sim/model/model.hpp"

namespace palpate::app {

/// What a cycle takes under one contact model.
struct ModelCost {
  sim::CycleCost cycle;
  std::vector<sim::ToleranceCost> tolerances{};  // empty: the contact model knows no bound of an error
};

/// What it takes in one scene.
struct SceneCost {
  std::string scene;
  int nodes = 0;      // of all bodies, as the paper counts them
  int touchable = 0;  // of these
  std::vector<ModelCost> models;
};

/// Times a compiled scene under its contact models. @param only  of one alone; empty: of each
SceneCost measure_cycle_times(const sim::Model& model, double depth, const std::string& only);

void print_cycle_times(const std::vector<SceneCost>& costs);

/// "units", "machine", "versions", "scenes" and "published".
nlohmann::ordered_json cycle_times_json(const std::vector<SceneCost>& costs);

/// Time over the number of nodes of all bodies, under the last model measured.
Plot over_nodes(const std::vector<SceneCost>& costs);
/// One scene: time over the depth of the press, one curve a model.
Plot over_depth(const SceneCost& scene);

/// Where a contact model may stop early: the picture of time against bound, beside the others.
void draw_tolerances(const std::vector<SceneCost>& costs, const std::string& plot);

/// Versions of program and compiler.
std::string versions();

}  // namespace palpate::app
