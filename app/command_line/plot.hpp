#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace palpate::app {

struct PlotSeries {
  std::string name;  // in the key
  std::vector<double> x{};
  std::vector<double> y{};  // as many; a value that is not finite is a gap
  bool dashed = false;      // a limit or a comparison rather than a result
};

/// A line plot: series over a common axis, in colours that colour-blind readers tell apart, and each with a
/// mark of its own, so that it can be read in black and white.
struct Plot {
  std::string title;
  std::string note{};   // small, under the title: machine, versions, source
  std::string x_label;  // with the unit, e.g. "depth [mm]"
  std::string y_label;
  bool log_x = false;
  bool log_y = false;
  std::vector<PlotSeries> series{};
};

/// Throws std::invalid_argument for a file name that ends in neither .svg nor .png, and for a folder that is
/// not there. Commands call it before
/// they start to compute.
void check_plot_file(const std::filesystem::path& file);

/// Draws with gnuplot and writes the picture aside, then renames it.
/// Throws std::invalid_argument as above, std::runtime_error when gnuplot is not installed (says how to
/// install it) or fails (with its words).
void draw_plot(const Plot& plot, const std::filesystem::path& file);

}  // namespace palpate::app
