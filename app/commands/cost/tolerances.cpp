#include "app/commands/cost/tolerances.hpp"

#include <fmt/format.h>

namespace palpate::app {

using nlohmann::ordered_json;

void print_tolerances(const std::vector<sim::ToleranceCost>& costs) {
  fmt::print("{:<9} {:>8}  {:<12} {:>9} {:>9} {:>12} {:>9} {:>12}\n", "", "", "tolerance", "median", "p99.9",
             "bound [%]:", "largest", "ended early");
  for (const sim::ToleranceCost& cost : costs)
    fmt::print("{:<20}{:<12} {:>9.2f} {:>9.2f} {:>12.2g} {:>9.2g} {:>10.1f} %\n", "",
               fmt::format("{:g} %", 100 * cost.tolerance), cost.total.median, cost.total.p999,
               100 * cost.median_bound, 100 * cost.largest_bound, 100.0 * cost.ended_early / cost.cycles);
}

ordered_json tolerances_json(const std::vector<sim::ToleranceCost>& costs) {
  ordered_json all = ordered_json::array();
  for (const sim::ToleranceCost& cost : costs)
    all.push_back({{"tolerance", cost.tolerance},
                   {"median", cost.total.median},
                   {"p99", cost.total.p99},
                   {"p99_9", cost.total.p999},
                   {"slowest", cost.total.slowest},
                   {"bound", {{"median", cost.median_bound}, {"largest", cost.largest_bound}}},
                   {"cycles", cost.cycles},
                   {"ended_early", cost.ended_early}});
  return all;
}

Plot over_bound(const std::vector<Tolerances>& all, const std::string& note) {
  std::string tolerances;
  for (const sim::ToleranceCost& cost : all.front().costs)
    tolerances += fmt::format("{}{:g} %", tolerances.empty() ? "" : ", ", 100 * cost.tolerance);
  Plot plot{.title = "One haptic cycle that may stop early",
            .note = fmt::format("contact.tolerance {}; median, shaded up to the time that 99.9 % of the "
                                "cycles keep; {}",
                                tolerances, note),
            .x_label = "largest bound of the force's error [% of the force]",
            .y_label = "time [µs]",
            .log_x = true,
            .log_y = true,
            .panels = {{}}};
  for (const Tolerances& one : all) {
    PlotSeries series{.name = fmt::format("{}: {}", one.model, one.scene)};
    for (const sim::ToleranceCost& cost : one.costs) {
      series.x.push_back(100 * cost.largest_bound);
      series.y.push_back(cost.total.median);
      series.high.push_back(cost.total.p999);
    }
    plot.panels.front().series.push_back(std::move(series));
  }
  return plot;
}

std::filesystem::path tolerance_plot_file(const std::filesystem::path& plot) {
  return plot.parent_path() / (plot.stem().string() + "-tolerance" + plot.extension().string());
}

}  // namespace palpate::app
