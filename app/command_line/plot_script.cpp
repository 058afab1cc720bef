#include "app/command_line/plot_script.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>

#include "app/command_line/plot_layout.hpp"

namespace palpate::app {
namespace {

// Source: [OkabeIto2008].
constexpr std::array<const char*, 7> kColours = {"#0072B2", "#D55E00", "#009E73", "#CC79A7",
                                                 "#E69F00", "#56B4E9", "#000000"};
// Open shapes over filled ones and dashes over a line, so that curves that lie on each other are both seen.
constexpr std::array<int, 7> kMarks = {7, 4, 9, 12, 5, 6, 13};
constexpr std::array<const char*, 4> kDashes = {"solid", "(10,6)", "(3,4)", "(10,4,2,4)"};
constexpr double kPngScale = 1.5;  // pixels of a PNG file for one of an SVG file

/// As gnuplot reads a text between single quotes.
std::string quoted(const std::string& text) {
  std::string result = "'";
  for (const char c : text) {
    if (c == '\'') result += '\'';
    result += c == '\n' ? ' ' : c;
  }
  return result + "'";
}

/// Names in the key, in the order in which they come.
std::vector<std::string> names_of(const Plot& plot) {
  std::vector<std::string> names;
  for (const PlotPanel& panel : plot.panels)
    for (const PlotSeries& series : panel.series)
      if (std::ranges::find(names, series.name) == names.end()) names.push_back(series.name);
  return names;
}

struct Range {
  double least = std::numeric_limits<double>::infinity(), most = -std::numeric_limits<double>::infinity();
  void add(double value) {
    if (!std::isfinite(value)) return;
    least = std::min(least, value);
    most = std::max(most, value);
  }
};

/// One range for all panels, a little beyond the data. @param from_zero  an axis that begins at 0, or below
std::string range_of(const char* axis, Range data, bool log, bool from_zero) {
  if (log)
    return fmt::format("set logscale {0}\nset {0}range [{1:g}:{2:g}]\n", axis, data.least / 1.3,
                       data.most * (from_zero ? 2.0 : 1.3));
  if (from_zero) data.add(0.0);
  if (!(data.most > data.least)) data = {.least = data.least, .most = data.least + 1};
  const double beyond = from_zero ? 0.06 * (data.most - data.least) : 0.0;
  return fmt::format("set {}range [{:.9g}:{:.9g}]\n", axis, data.least < 0 ? data.least - beyond : data.least,
                     data.most + beyond);
}

std::string ranges(const Plot& plot) {
  Range x, y;
  for (const PlotPanel& panel : plot.panels) {
    for (const PlotSeries& series : panel.series) {
      for (const double value : series.x) x.add(value);
      for (const double value : series.y) y.add(value);
      for (const double value : series.high) y.add(value);
    }
  }
  for (const PlotLimit& limit : plot.limits) y.add(limit.y);
  for (const PlotBand& band : plot.bands) {
    x.add(band.low);
    x.add(band.high);
  }
  return range_of("x", x, plot.log_x, false) + range_of("y", y, plot.log_y, true);
}

/// The rows of one series: x, y and, of a band, its upper end.
std::string data_block(const PlotSeries& series, std::size_t panel, std::size_t number) {
  assert(series.x.size() == series.y.size() &&
         (series.high.empty() || series.high.size() == series.x.size()));
  std::string text = fmt::format("$p{}s{} << end_of_series\n", panel, number);
  for (std::size_t k = 0; k < series.x.size(); ++k) {
    const double high = series.high.empty() ? series.y[k] : series.high[k];
    if (std::isfinite(series.x[k]) && std::isfinite(series.y[k]) && std::isfinite(high))
      text += fmt::format("{:.17g} {:.17g} {:.17g}\n", series.x[k], series.y[k], high);
    else
      text += "\n";  // an empty line breaks the curve
  }
  return text + "end_of_series\n";
}

std::string look(std::size_t name, std::size_t points_a_mark) {
  return fmt::format(
      "with linespoints linecolor '{}' pointtype {} pointinterval {} pointsize 0.6 linewidth 2 dashtype {}",
      kColours[name % kColours.size()], kMarks[name % kMarks.size()], points_a_mark,
      kDashes[name % kDashes.size()]);
}

std::string curves(const PlotPanel& panel, std::size_t number, const std::vector<std::string>& names) {
  std::string text;
  for (const bool bands : {true, false}) {
    for (std::size_t i = 0; i < panel.series.size(); ++i) {
      const PlotSeries& series = panel.series[i];
      const auto name = static_cast<std::size_t>(std::ranges::find(names, series.name) - names.begin());
      if (bands && series.high.empty()) continue;
      text += text.empty() ? "plot " : ", ";
      if (bands)
        text += fmt::format(
            "$p{}s{} using 1:2:3 with filledcurves linecolor '{}' fillstyle solid 0.18 noborder notitle",
            number, i, kColours[name % kColours.size()]);
      else
        text += fmt::format("$p{}s{} using 1:2 {} notitle", number, i, look(name, 1 + series.x.size() / 25));
    }
  }
  return text + "\n";
}

std::string margins(const PlotBox& box) {
  return fmt::format(
      "set lmargin at screen {:.6f}\nset rmargin at screen {:.6f}\nset bmargin at screen {:.6f}\n"
      "set tmargin at screen {:.6f}\n",
      box.left, box.right, box.bottom, box.top);
}

std::string terminal(const PlotLayout& page, bool svg) {
  if (svg)
    return fmt::format(
        "set terminal svg size {:.0f},{:.0f} dynamic noenhanced font 'sans-serif,13' background '#ffffff'\n",
        page.width, page.height);
  return fmt::format("set terminal pngcairo size {:.0f},{:.0f} noenhanced font 'sans,18' linewidth 1.4\n",
                     kPngScale * page.width, kPngScale * page.height);
}

/// Lines of text under each other, from `top` on; every line a label of its own, with a number from `first`.
std::string heading(const std::vector<std::string>& lines, double top, double line, const std::string& font,
                    int& number) {
  std::string text;
  for (std::size_t i = 0; i < lines.size(); ++i)
    text += fmt::format("set label {} {} at screen 0.5,screen {:.6f} center {}\n", ++number, quoted(lines[i]),
                        top - (static_cast<double>(i) + 0.5) * line, font);
  return text;
}

/// Where it is clear of the numbers, however long they are: gnuplot's own would leave the page.
std::string y_label(const Plot& plot, const PlotLayout& page, const PlotBox& axes, int number) {
  return fmt::format("set label {} {} at screen {:.6f},screen {:.6f} center rotate by 90\n", number,
                     quoted(plot.y_label), axes.left - 66 / page.width, (axes.bottom + axes.top) / 2);
}

std::string limit_lines(const Plot& plot) {
  std::string text = "set style textbox opaque noborder margins 0.4,0.2\n";
  for (std::size_t i = 0; i < plot.limits.size(); ++i) {
    const PlotLimit& limit = plot.limits[i];
    text += fmt::format(
        "set arrow {0} from graph 0,first {1:.17g} to graph 1,first {1:.17g} nohead linecolor '#666666' "
        "linewidth 1.6 dashtype 4\n"
        "set label {0} {2} at graph 0.02,first {1:.17g} left offset 0,0.6 textcolor '#444444'\n",
        100 + i, limit.y, quoted(limit.name));
  }
  return text;
}

std::string shaded_bands(const Plot& plot) {
  std::string text;
  for (std::size_t i = 0; i < plot.bands.size(); ++i) {
    const PlotBand& band = plot.bands[i];
    const double middle = plot.log_x ? std::sqrt(band.low * band.high) : 0.5 * (band.low + band.high);
    text += fmt::format(
        "set object {0} rectangle from first {1:.17g},graph 0 to first {2:.17g},graph 1 behind fillcolor '#E69F00' "
        "fillstyle solid 0.25 noborder\n"
        "set label {0} {4} at first {3:.17g},graph 0.97 right rotate by 90 textcolor '#8a5a00'\n",
        200 + i, band.low, band.high, middle, quoted(band.name));
  }
  return text;
}

std::string key(const PlotLayout& page, const std::vector<std::string>& names) {
  if (names.size() < 2) return "";
  std::string text =
      margins(page.key) +
      "unset title\nunset xlabel\nunset ylabel\nunset tics\nunset border\nunset grid\n"
      "unset label\nunset arrow\nunset object\nunset logscale\nset xrange [0:1]\nset yrange [0:1]\n";
  text += fmt::format("set key inside center center horizontal Left reverse maxcols {} width 1\n",
                      page.key_columns);
  for (std::size_t i = 0; i < names.size(); ++i)
    text += fmt::format("{} NaN {} title {}", i == 0 ? "plot" : ",", look(i, 1), quoted(names[i]));
  return text + "\n";
}

}  // namespace

std::string plot_script(const Plot& plot, bool svg) {
  const std::vector<std::string> names = names_of(plot);
  const PlotLayout page = layout_of(plot, names);
  std::string text = "set encoding utf8\n" + terminal(page, svg);
  for (std::size_t p = 0; p < plot.panels.size(); ++p)
    for (std::size_t i = 0; i < plot.panels[p].series.size(); ++i)
      text += data_block(plot.panels[p].series[i], p, i);
  text += "set multiplot\nunset key\n" + ranges(plot) + limit_lines(plot) + shaded_bands(plot);
  text += "set border 3 linecolor '#444444'\nset tics nomirror\nset grid linecolor '#e4e4e4' linetype 1\n";
  int label = 0;
  text += heading(page.title, page.title_at, 18 / page.height, svg ? "font ',15'" : "font ',21'", label);
  text += heading(page.note, page.note_at, 14 / page.height,
                  svg ? "font ',10' textcolor '#555555'" : "font ',14' textcolor '#555555'", label);
  for (std::size_t p = 0; p < plot.panels.size(); ++p) {
    std::string title;
    for (const std::string& line : page.panel_titles[p])
      title += (title.empty() ? "" : ".\"\\n\".") + quoted(line);
    text += margins(page.panels[p]) +
            (title.empty() ? "unset title\n" : fmt::format("set title {} offset 0,-0.4\n", title));
    const bool lowest = p + page.across >= plot.panels.size(), leftmost = p % page.across == 0;
    text += fmt::format("set xlabel {} offset 0,0.4\n", lowest ? quoted(plot.x_label) : "''");
    if (leftmost) text += y_label(plot, page, page.panels[p], ++label);
    text += curves(plot.panels[p], p, names);
    for (; label > 0; --label) text += fmt::format("unset label {}\n", label);  // the page's words once
  }
  return text + key(page, names) + "unset multiplot\n";
}

}  // namespace palpate::app
