#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace palpate::app {

struct PlotSeries {
  std::string name;  // in the key; one of this name in another panel looks the same
  std::vector<double> x{};
  std::vector<double> y{};     // as many; a value that is not finite is a gap
  std::vector<double> high{};  // as many, or none: a band from y up to here
};

/// Series over axes of their own, which are the same in all panels.
struct PlotPanel {
  std::string title{};
  std::vector<PlotSeries> series{};
};

/// A line across every panel with its words on it.
struct PlotLimit {
  std::string name;
  double y = 0.0;
};

/// What lies between two x, shaded over every panel, with its words.
struct PlotBand {
  std::string name;
  double low = 0.0, high = 0.0;
};

/// A line plot: panels side by side over common axes, in colours that colour-blind readers tell apart, and each
/// series with a mark and dashes of its own, so that it can be read in black and white.
struct Plot {
  std::string title;
  std::string note{};   // small, under the title: machine, versions, source
  std::string x_label;  // with the unit, e.g. "depth [mm]"
  std::string y_label;
  bool log_x = false;
  bool log_y = false;
  std::vector<PlotPanel> panels{};
  std::vector<PlotLimit> limits{};
  std::vector<PlotBand> bands{};
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
