#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/command_line/plot.hpp"
#include "sim/cost/tolerance_cost.hpp"

namespace palpate::app {

/// Of one contact model in one scene: what a cycle takes under each tolerance.
struct Tolerances {
  std::string scene;
  std::string model;
  std::vector<sim::ToleranceCost> costs;
};

/// A table for a terminal. @param costs  not empty
void print_tolerances(const std::vector<sim::ToleranceCost>& costs);
nlohmann::ordered_json tolerances_json(const std::vector<sim::ToleranceCost>& costs);

/// Time over the largest bound of the force's error, both logarithmic, one curve a scene and contact model.
/// @param note  machine and versions
Plot over_bound(const std::vector<Tolerances>& all, const std::string& note);

/// Beside a plot's file: "cost.svg" gives "cost-tolerance.svg".
std::filesystem::path tolerance_plot_file(const std::filesystem::path& plot);

}  // namespace palpate::app
