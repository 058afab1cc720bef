#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "analysis/report/pictures.hpp"
#include "analysis/report/summary.hpp"
#include "analysis/report/svg.hpp"
#include "analysis/words/words.hpp"

namespace palpate::analysis {
namespace {

constexpr double kPlot = 570, kMargin = 30, kTop = 64, kRow = 104, kBar = 26, kHill = 40;

// Cells of one size share an axis of counts; cells of different sizes are only comparable in percent.
struct Scale {
  Axis axis{};
  bool counts = true;
  double left() const { return axis.pixel_low; }
  double at(double correct, long trials) const {
    return axis.at(counts ? correct : 100 * correct / static_cast<double>(trials));
  }
};

Scale scale_of(const StudyReport& report) {
  long trials = 0;
  bool counts = true;
  for (const CellResult& cell : report.cells) {
    if (cell.trials == 0) continue;
    counts = counts && (trials == 0 || trials == cell.trials);
    trials = cell.trials;
  }
  Scale scale{.counts = counts};
  scale.axis = counts ? nice_axis(0, static_cast<double>(std::max(1L, trials)), 10, false, "correct answers")
                      : nice_axis(0, 100, 10, false, "correct answers (%)");
  std::erase_if(scale.axis.ticks, [counts](double tick) { return counts && tick != std::floor(tick); });
  scale.axis.decimals = 0;
  std::vector<std::string> names;
  for (const CellResult& cell : report.cells) names.push_back(cell.name);
  scale.axis.pixel_low = room_for(names, 120);
  scale.axis.pixel_high = scale.axis.pixel_low + kPlot;
  return scale;
}

// The distribution of the number correct under guessing, drawn as a hill whose rejected part is darker.
std::string hill(const CellResult& cell, const Scale& scale, double base) {
  const std::vector<double>& guessing = cell.primary->under_guessing;
  const double top = *std::ranges::max_element(guessing);
  const auto seen = [top](double probability) { return probability > 1e-4 * top; };
  const auto first = std::ranges::find_if(guessing, seen) - guessing.begin();
  const auto last = guessing.rend() - std::find_if(guessing.rbegin(), guessing.rend(), seen) - 1;
  const double centre = cell.primary->chance * static_cast<double>(cell.trials);
  std::vector<std::pair<double, double>> all, rejected_low, rejected_high;
  const auto add = [&](auto& points, long k) {
    const double height = base - kHill * guessing[k] / top;
    points.emplace_back(scale.at(static_cast<double>(k) - 0.5, cell.trials), height);
    points.emplace_back(scale.at(static_cast<double>(k) + 0.5, cell.trials), height);
  };
  for (long k = first; k <= last; ++k) {
    add(all, k);
    if (!rejects(cell.primary->critical, k)) continue;
    add(static_cast<double>(k) > centre ? rejected_high : rejected_low, k);
  }
  std::string marks;
  const auto draw = [&](auto& points, std::string_view style) {
    if (points.empty()) return;
    points.emplace(points.begin(), points.front().first, base);
    points.emplace_back(points.back().first, base);
    marks += path(points, true, style);
  };
  draw(all, "class=\"guess\"");
  draw(rejected_low, "class=\"rejected\"");
  draw(rejected_high, "class=\"rejected\"");
  return marks;
}

std::string critical_mark(double x, double y, const std::string& text, bool left) {
  return line(x, y - kHill - 8, x, y + kBar + 8, "class=\"critical\"") +
         label(x + (left ? -5 : 5), y - kHill - 1, left ? "end" : "start", text, "class=\"critical-text\"");
}

// Interval, critical numbers and the hill: everything that is an inference.
std::string inference(const CellResult& cell, const Scale& scale, double y) {
  const double n = static_cast<double>(cell.trials), middle = y + kBar / 2;
  const double lower = scale.at(cell.primary->interval.lower * n, cell.trials);
  const double upper = scale.at(cell.primary->interval.upper * n, cell.trials);
  std::string marks = line(lower, middle, upper, middle, "class=\"whisker\"") +
                      line(lower, middle - 6, lower, middle + 6, "class=\"whisker\"") +
                      line(upper, middle - 6, upper, middle + 6, "class=\"whisker\"");
  if (cell.primary->critical.at_least) {
    const double k = static_cast<double>(*cell.primary->critical.at_least);
    marks += critical_mark(scale.at(k - 0.5, cell.trials), y,
                           fmt::format("{} or more", *cell.primary->critical.at_least), false);
  }
  if (cell.primary->critical.at_most) {
    const double k = static_cast<double>(*cell.primary->critical.at_most);
    marks += critical_mark(scale.at(k + 0.5, cell.trials), y,
                           fmt::format("{} or fewer", *cell.primary->critical.at_most), true);
  }
  return marks;
}

std::string row(const CellResult& cell, const Scale& scale, double y, std::size_t index) {
  std::string marks = label(scale.left() - 12, y + kBar / 2 - 2, "end", cell.name, "class=\"row\"");
  if (cell.trials == 0)
    return marks + label(scale.left() + 6, y + kBar / 2 + 5, "start", "no answers", "class=\"tick\"");
  marks += label(scale.left() - 12, y + kBar / 2 + 15, "end",
                 fmt::format("{} of {}", cell.correct, cell.trials), "class=\"tick\"");
  if (cell.primary) marks += hill(cell, scale, y);
  const double end = scale.at(static_cast<double>(cell.correct), cell.trials);
  marks += rectangle(scale.left(), y, end - scale.left(), kBar,
                     fmt::format("fill=\"{}\" class=\"bar\"", colour(index)));
  return cell.primary ? marks + inference(cell, scale, y) : marks;
}

std::string description(const StudyReport& report) {
  std::string text;
  for (const CellResult& cell : report.cells) {
    text += fmt::format("{}: {} correct of {}. ", cell.name, cell.correct, cell.trials);
    if (cell.primary && !region_in_words(cell.primary->critical).empty()) {
      text += fmt::format("Guessing is rejected by {}. ", region_in_words(cell.primary->critical));
    }
  }
  return text;
}

}  // namespace

std::string answers_picture(const StudyReport& report) {
  const Scale scale = scale_of(report);
  const double bottom = kTop + kRow * static_cast<double>(report.cells.size()) - 30;
  std::string marks = horizontal_axis(scale.axis, bottom, kTop - 52);
  for (std::size_t i = 0; i < report.cells.size(); ++i) {
    marks += row(report.cells[i], scale, kTop + kRow * static_cast<double>(i), i);
  }
  const double chance = scale.axis.at(report.design.chance * scale.axis.high);
  marks += line(chance, bottom, chance, kTop - 52, "class=\"chance\"");
  return picture("answers", scale.axis.pixel_high + kMargin, bottom + 52,
                 "Correct answers against the critical number", description(report), marks);
}

}  // namespace palpate::analysis
