#include <fmt/core.h>

#include <algorithm>
#include <map>

#include "analysis/report/pictures.hpp"
#include "analysis/report/svg.hpp"

namespace palpate::analysis {
namespace {

constexpr double kPanel = 300, kGap = 72, kLeft = 66, kTop = 60, kHeight = 230;

// Millimetres and newtons, as the page shows them.
struct Extent {
  double depth_mm = 0.0, low_n = 0.0, high_n = 0.0;
};

Extent extent_of(const std::vector<ForceCurve>& curves) {
  Extent extent;
  for (const ForceCurve& curve : curves) {
    for (std::size_t i = 0; i < curve.depth_m.size(); ++i) {
      const double spread = curve.deviation_n.empty() ? 0.0 : curve.deviation_n[i];
      extent.depth_mm = std::max(extent.depth_mm, 1000 * curve.depth_m[i]);
      extent.low_n = std::min(extent.low_n, curve.mean_force_n[i] - spread);
      extent.high_n = std::max(extent.high_n, curve.mean_force_n[i] + spread);
    }
  }
  return extent;
}

std::string curve_marks(const ForceCurve& curve, std::size_t style, const Axis& x, const Axis& y) {
  std::vector<std::pair<double, double>> mean, band;
  for (std::size_t i = 0; i < curve.depth_m.size(); ++i) {
    mean.emplace_back(x.at(1000 * curve.depth_m[i]), y.at(curve.mean_force_n[i]));
    if (!curve.deviation_n.empty()) {
      band.emplace_back(mean.back().first, y.at(curve.mean_force_n[i] + curve.deviation_n[i]));
    }
  }
  for (std::size_t i = band.size(); i-- > 0;) {
    band.emplace_back(mean[i].first, y.at(curve.mean_force_n[i] - curve.deviation_n[i]));
  }
  const std::string_view ink = colour(style), dashes = dash(style);
  std::string marks;
  if (!band.empty()) marks += path(band, true, fmt::format("fill=\"{}\" fill-opacity=\"0.14\"", ink));
  return marks + path(mean, false,
                      fmt::format("fill=\"none\" stroke=\"{}\" stroke-width=\"2.2\" stroke-dasharray=\"{}\"",
                                  ink, dashes.empty() ? "none" : dashes));
}

// Conditions keep their colour and dash in every panel.
std::map<std::string, std::size_t> styles_of(const StudyReport& report) {
  std::map<std::string, std::size_t> styles;
  for (const std::string& condition : report.design.conditions) styles.try_emplace(condition, styles.size());
  for (const ForceCurve& curve : report.curves) styles.try_emplace(curve.condition, styles.size());
  return styles;
}

std::string legend(const std::map<std::string, std::size_t>& styles) {
  std::vector<std::string> names(styles.size());
  for (const auto& [name, style] : styles) names[style] = name;
  std::string marks;
  double x = kLeft;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::string_view dashes = dash(i);
    marks += line(x, 16, x + 30, 16,
                  fmt::format("stroke=\"{}\" stroke-width=\"2.2\" stroke-dasharray=\"{}\"", colour(i),
                              dashes.empty() ? "none" : dashes));
    marks += label(x + 37, 21, "start", names[i], "class=\"legend\"");
    x += 64 + 8.0 * static_cast<double>(names[i].size());
  }
  return marks;
}

std::string panel(const StudyReport& report, std::size_t cell, const Extent& extent, double left,
                  double top) {
  Axis x = nice_axis(0, extent.depth_mm, 5, true, "depth (mm)");
  Axis y = nice_axis(extent.low_n, extent.high_n, 5, true, "force (N)");
  x.pixel_low = left, x.pixel_high = left + kPanel;
  y.pixel_low = top + kHeight, y.pixel_high = top;
  std::string marks = label(left, top - 12, "start", report.design.cells[cell].name, "class=\"row\"") +
                      horizontal_axis(x, top + kHeight, top) + vertical_axis(y, left, left + kPanel);
  const std::map<std::string, std::size_t> styles = styles_of(report);
  for (const ForceCurve& curve : report.curves) {
    if (curve.cell == cell) marks += curve_marks(curve, styles.at(curve.condition), x, y);
  }
  return marks;
}

}  // namespace

std::string curves_picture(const StudyReport& report) {
  const Extent extent = extent_of(report.curves);
  if (!(extent.depth_mm > 0)) return "";
  const std::size_t panels = report.design.cells.size(), across = std::min<std::size_t>(panels, 2);
  const std::size_t rows = (panels + across - 1) / across;
  std::string marks = legend(styles_of(report));
  for (std::size_t cell = 0; cell < panels; ++cell) {
    const std::size_t row = cell / across, column = cell % across;
    marks += panel(report, cell, extent, kLeft + (kPanel + kGap) * static_cast<double>(column),
                   kTop + (kHeight + 86) * static_cast<double>(row));
  }
  const double width = kLeft + static_cast<double>(across) * (kPanel + kGap) - kGap + 14;
  return picture(
      "curves", std::max(width, 520.0), kTop + static_cast<double>(rows) * (kHeight + 86) - 30,
      "Mean force over depth",
      "One panel for each cell, one line for each condition; the data stand in a table at the end.", marks);
}

}  // namespace palpate::analysis
