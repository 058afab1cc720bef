#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "app/command_line/plot.hpp"

namespace palpate::app {

/// A part of the page as shares of it, as gnuplot counts: from the lower left corner.
struct PlotBox {
  double left = 0.0, right = 0.0, bottom = 0.0, top = 0.0;
};

/// Where everything lies, so that nothing overlaps however many panels, series and long names there are.
struct PlotLayout {
  double width = 0.0, height = 0.0;  // of the page [pixel of the SVG file]
  std::size_t across = 1;            // panels in a row
  std::vector<std::string> title{};  // lines
  std::vector<std::string> note{};
  double title_at = 0.0, note_at = 0.0;                // upper edge of their first lines, share of the page
  std::vector<PlotBox> panels{};                       // the axes of each
  std::vector<std::vector<std::string>> panel_titles;  // lines of each
  PlotBox key{};
  std::size_t key_columns = 1;
};

/// @param names  in the key; with one only there is none
PlotLayout layout_of(const Plot& plot, const std::vector<std::string>& names);

/// Lines of at most `most` characters (of UTF-8), broken at spaces; within a word only where it is longer.
std::vector<std::string> wrapped(std::string_view text, std::size_t most);

}  // namespace palpate::app
