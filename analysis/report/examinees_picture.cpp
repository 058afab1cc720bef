#include <fmt/core.h>

#include <algorithm>
#include <array>

#include "analysis/report/pictures.hpp"
#include "analysis/report/svg.hpp"
#include "analysis/words/words.hpp"

namespace palpate::analysis {
namespace {

constexpr double kLeast = 120, kPlot = 570, kMargin = 30, kTop = 44;
constexpr std::size_t kLabelled = 60;  // rows that still have room for a code each

// A shape for each cell, so that the colours are not needed: disc, square, diamond, ring.
std::string marker(std::size_t cell, double x, double y, double size) {
  const std::string fill = fmt::format("fill=\"{}\" class=\"dot\"", colour(cell));
  switch (cell % 4) {
    case 0:
      return circle(x, y, size, fill);
    case 1:
      return rectangle(x - 0.9 * size, y - 0.9 * size, 1.8 * size, 1.8 * size, fill);
    case 2:
      return path({{x, y - 1.3 * size}, {x + 1.3 * size, y}, {x, y + 1.3 * size}, {x - 1.3 * size, y}}, true,
                  fill);
    default:
      return circle(x, y, size, fmt::format("fill=\"none\" stroke=\"{}\" stroke-width=\"2\"", colour(cell)));
  }
}

// Where a name of the legend stands: as many in a line as fit.
struct LegendPlace {
  double x = 0.0, y = 0.0;
};

std::vector<LegendPlace> legend_places(const StudyReport& report, double left) {
  std::vector<LegendPlace> places;
  double x = left, y = 16;
  for (const CellResult& cell : report.cells) {
    const double room = room_for({cell.name}, 0) + 20;
    if (x > left && x + room > left + kPlot) x = left, y += 24;
    places.push_back({x, y});
    x += room;
  }
  return places;
}

std::string legend(const StudyReport& report, const std::vector<LegendPlace>& places) {
  std::string marks;
  for (std::size_t c = 0; c < report.cells.size(); ++c)
    marks += marker(c, places[c].x + 6, places[c].y, 5) +
             label(places[c].x + 18, places[c].y + 5, "start", report.cells[c].name, "class=\"legend\"");
  return marks;
}

// Marks of one examinee; equal proportions are drawn side by side, a little apart, so that none hides
// another.
std::string row(const StudyReport& report, std::size_t examinee, const Axis& axis, double y, double size) {
  std::vector<std::pair<double, std::size_t>> marks;
  for (std::size_t c = 0; c < report.cells.size(); ++c) {
    const ExamineeCount& count = report.cells[c].by_examinee[examinee];
    if (count.trials > 0) {
      marks.emplace_back(
          axis.at(100.0 * static_cast<double>(count.correct) / static_cast<double>(count.trials)), c);
    }
  }
  if (marks.empty()) return "";
  const auto [least, most] = std::minmax_element(marks.begin(), marks.end());
  std::string text = line(least->first, y, most->first, y, "class=\"link\"");
  for (std::size_t i = 0; i < marks.size(); ++i) {
    double before = 0, same = 0;
    for (std::size_t j = 0; j < marks.size(); ++j) {
      if (marks[j].first != marks[i].first) continue;
      ++same;
      before += j < i;
    }
    text += marker(marks[i].second, marks[i].first + 2.2 * size * (before - (same - 1) / 2), y, size);
  }
  return text;
}

// How many examinees have which percentage, a panel for each cell: where rows would fill pages.
std::string histogram(const StudyReport& report) {
  constexpr int kBins = 20;
  constexpr double kPanel = 110;
  Axis x = nice_axis(0, 100, 5, false, "correct answers (%)");
  std::vector<std::string> names;
  for (const CellResult& cell : report.cells) names.push_back(cell.name);
  const double left_end = room_for(names, kLeast), right_end = left_end + kPlot;
  x.pixel_low = left_end, x.pixel_high = right_end;
  const double bottom = kTop + kPanel * static_cast<double>(report.cells.size());
  const double chance = x.at(100 * report.design.chance);
  std::string marks =
      horizontal_axis(x, bottom, kTop - 20) + line(chance, bottom, chance, kTop - 20, "class=\"chance\"");
  for (std::size_t c = 0; c < report.cells.size(); ++c) {
    std::array<long, kBins> counts{};
    for (const ExamineeCount& count : report.cells[c].by_examinee) {
      if (count.trials > 0) ++counts[std::min((kBins - 1L), kBins * count.correct / count.trials)];
    }
    const double most = static_cast<double>(std::max(1L, *std::ranges::max_element(counts)));
    const double base = kTop + kPanel * static_cast<double>(c + 1);
    for (std::size_t bin = 0; bin < kBins; ++bin) {
      const double left = x.at(100.0 / kBins * static_cast<double>(bin)),
                   right = x.at(100.0 / kBins * static_cast<double>(bin + 1));
      const double height = (kPanel - 26) * static_cast<double>(counts[bin]) / most;
      marks += rectangle(left + 1, base - height, right - left - 2, height,
                         fmt::format("fill=\"{}\" class=\"bar\"", colour(c)));
    }
    marks += line(left_end, base, right_end, base, "class=\"axis\"") +
             label(left_end - 12, base - 6, "end", report.cells[c].name, "class=\"row\"") +
             label(right_end, base - kPanel + 20, "end", fmt::format("tallest bar: {:.0f} examinees", most),
                   "class=\"tick\"");
  }
  return picture("examinees", right_end + kMargin, bottom + 52, "Examinees by their percentage correct",
                 "The number of examinees in steps of 5 percent, a panel for each cell; a table gives each "
                 "one's counts.",
                 marks);
}

}  // namespace

std::string examinees_picture(const StudyReport& report) {
  if (report.examinees.empty()) return "";
  if (report.examinees.size() > kMostRows) return histogram(report);
  const bool labelled = report.examinees.size() <= kLabelled;
  const double height = labelled ? 20 : 9, size = labelled ? 5 : 3;
  Axis axis = nice_axis(0, 100, 5, false, "correct answers (%)");
  axis.pixel_low = room_for(report.examinees, kLeast);
  axis.pixel_high = axis.pixel_low + kPlot;
  const std::vector<LegendPlace> places = legend_places(report, axis.pixel_low);
  const double top = kTop + places.back().y - places.front().y;
  const double bottom = top + height * static_cast<double>(report.examinees.size()) + 6;
  const double chance = axis.at(100 * report.design.chance);
  std::string marks = legend(report, places) + horizontal_axis(axis, bottom, top - 8) +
                      line(chance, bottom, chance, top - 8, "class=\"chance\"");
  for (std::size_t i = 0; i < report.examinees.size(); ++i) {
    const double y = top + height * (static_cast<double>(i) + 0.5);
    if (labelled || i % 10 == 0)
      marks += label(axis.pixel_low - 12, y + 4, "end", report.examinees[i], "class=\"tick\"");
    marks += row(report, i, axis, y, size);
  }
  return picture(
      "examinees", axis.pixel_high + kMargin, bottom + 52, "Correct answers of each examinee",
      fmt::format("A row for each of {} with the percentage correct under {}; the table below gives the "
                  "counts.",
                  counted(static_cast<long>(report.examinees.size()), "examinee", "examinees"),
                  counted(static_cast<long>(report.cells.size()), "cell", "cells")),
      marks);
}

}  // namespace palpate::analysis
