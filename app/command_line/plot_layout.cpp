#include "app/command_line/plot_layout.hpp"

#include <algorithm>

namespace palpate::app {
namespace {

// Pixels of the SVG file. A character of the 13 pixel font is taken for wide: viewers choose their own font.
constexpr double kCharacter = 7.8, kLine = 18.0;
constexpr double kSmallCharacter = 6.2, kSmallLine = 14.0;  // of the note
constexpr double kEdge = 12.0;
constexpr double kTicks = 28.0, kAxisName = 22.0;     // under the axes
constexpr double kTickNumbers = 82.0;                 // left of them, with the axis' name
constexpr double kBetween = 24.0;                     // right of them
constexpr double kKeySample = 64.0;                   // a line, and the gaps around it
constexpr double kWide = 654.0, kHigh = 380.0;        // axes of a panel that is alone
constexpr double kManyWide = 330.0, kManyHigh = 240;  // of one among others

bool begins_character(char c) {
  return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U;  // else a byte within one of UTF-8
}

std::size_t characters(std::string_view text) {
  return static_cast<std::size_t>(std::ranges::count_if(text, begins_character));
}

/// Bytes of the first `count` characters.
std::size_t bytes_of(std::string_view text, std::size_t count) {
  std::size_t at = 0;
  while (at < text.size() && (count > 0 || !begins_character(text[at])))
    count -= begins_character(text[at++]);
  return at;
}

std::size_t fitting(double width, double character) {
  return static_cast<std::size_t>(width / character);
}

std::size_t panels_across(std::size_t panels) {
  if (panels <= 3) return panels;
  return panels == 4 ? 2 : panels <= 9 ? 3 : 4;
}

}  // namespace

std::vector<std::string> wrapped(std::string_view text, std::size_t most) {
  std::vector<std::string> lines;
  while (characters(text) > most) {
    std::size_t end = bytes_of(text, most);
    std::size_t next = end;
    if (const auto space = text.substr(0, end + 1).rfind(' '); space != std::string_view::npos && space > 0) {
      end = space;
      next = space + 1;
    }
    lines.emplace_back(text.substr(0, end));
    text.remove_prefix(next);
  }
  if (!text.empty()) lines.emplace_back(text);
  return lines;
}

namespace {

/// Each lays its part below `at`, pixels from the top, and gives where the next one begins.
double lay_heading(const Plot& plot, double at, PlotLayout& page) {
  page.title = wrapped(plot.title, fitting(page.width - 2 * kEdge, 1.15 * kCharacter));
  page.title_at = at;
  at += kLine * static_cast<double>(page.title.size()) + 4;
  page.note = wrapped(plot.note, fitting(page.width - 2 * kEdge, kSmallCharacter));
  page.note_at = at;
  return at + kSmallLine * static_cast<double>(page.note.size()) + 10;
}

double lay_panels(const Plot& plot, double wide, double high, double at, PlotLayout& page) {
  std::size_t title_lines = 0;
  for (const PlotPanel& panel : plot.panels) {
    page.panel_titles.push_back(wrapped(panel.title, fitting(wide, kCharacter)));
    title_lines = std::max(title_lines, page.panel_titles.back().size());
  }
  const double titles = kLine * static_cast<double>(title_lines) + 6;
  const double row = titles + high + kTicks + kAxisName, column = kTickNumbers + wide + kBetween;
  for (std::size_t i = 0; i < plot.panels.size(); ++i) {
    if (i > 0 && i % page.across == 0) at += row;
    const double left = static_cast<double>(i % page.across) * column + kTickNumbers, top = at + titles;
    page.panels.push_back({.left = left, .right = left + wide, .bottom = top + high, .top = top});
  }
  return at + row + 6;
}

double lay_key(const std::vector<std::string>& names, double at, PlotLayout& page) {
  page.key = {.left = kEdge, .right = page.width - kEdge, .bottom = at, .top = at};
  if (names.size() < 2) return at;
  std::size_t longest = 0;
  for (const std::string& name : names) longest = std::max(longest, characters(name));
  const double entry = kKeySample + kCharacter * static_cast<double>(longest);
  page.key_columns = std::clamp<std::size_t>(fitting(page.width - 2 * kEdge, entry), 1, names.size());
  const std::size_t rows = (names.size() + page.key_columns - 1) / page.key_columns;
  page.key.bottom = at + kLine * static_cast<double>(rows);
  return page.key.bottom;
}

/// From pixels, counted from the top, to shares of the page, counted from below.
void take_shares(PlotLayout& page) {
  const auto up = [&](double pixels) { return 1 - pixels / page.height; };
  const auto share = [&](PlotBox& box) {
    box = {box.left / page.width, box.right / page.width, up(box.bottom), up(box.top)};
  };
  page.title_at = up(page.title_at);
  page.note_at = up(page.note_at);
  std::ranges::for_each(page.panels, share);
  share(page.key);
}

}  // namespace

PlotLayout layout_of(const Plot& plot, const std::vector<std::string>& names) {
  const bool alone = plot.panels.size() == 1;
  const double wide = alone ? kWide : kManyWide, high = alone ? kHigh : kManyHigh;
  PlotLayout page;
  page.across = panels_across(plot.panels.size());
  page.width = static_cast<double>(page.across) * (kTickNumbers + wide + kBetween);
  double at = lay_heading(plot, kEdge, page);
  at = lay_panels(plot, wide, high, at, page);
  at = lay_key(names, at, page);
  page.height = at + kEdge;
  take_shares(page);
  return page;
}

}  // namespace palpate::app
