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

PlotLayout layout_of(const Plot& plot, const std::vector<std::string>& names) {
  PlotLayout page;
  const std::size_t panels = plot.panels.size(), across = panels_across(panels);
  const std::size_t down = (panels + across - 1) / across;
  const double wide = panels == 1 ? kWide : kManyWide, high = panels == 1 ? kHigh : kManyHigh;
  page.across = across;
  page.width = static_cast<double>(across) * (kTickNumbers + wide + kBetween);

  double at = kEdge;  // from the top
  page.title = wrapped(plot.title, fitting(page.width - 2 * kEdge, 1.15 * kCharacter));
  page.title_at = at;
  at += kLine * static_cast<double>(page.title.size()) + 4;
  page.note = wrapped(plot.note, fitting(page.width - 2 * kEdge, kSmallCharacter));
  page.note_at = at;
  at += kSmallLine * static_cast<double>(page.note.size()) + 10;

  std::size_t title_lines = 0;
  for (const PlotPanel& panel : plot.panels) {
    page.panel_titles.push_back(wrapped(panel.title, fitting(wide, kCharacter)));
    title_lines = std::max(title_lines, page.panel_titles.back().size());
  }
  const double titles = kLine * static_cast<double>(title_lines) + 6;
  for (std::size_t i = 0; i < panels; ++i) {
    const double left = static_cast<double>(i % across) * (kTickNumbers + wide + kBetween) + kTickNumbers;
    const double top = at + static_cast<double>(i / across) * (titles + high + kTicks + kAxisName) + titles;
    page.panels.push_back({.left = left, .right = left + wide, .bottom = top + high, .top = top});
  }
  at += static_cast<double>(down) * (titles + high + kTicks + kAxisName) + 6;

  std::size_t longest = 1;
  for (const std::string& name : names) longest = std::max(longest, characters(name));
  page.key_columns = std::clamp<std::size_t>(
      fitting(page.width - 2 * kEdge, kKeySample + kCharacter * static_cast<double>(longest)), 1,
      names.size());
  const std::size_t key_rows = (names.size() + page.key_columns - 1) / page.key_columns;
  const double key = names.size() > 1 ? kLine * static_cast<double>(key_rows) : 0.0;
  page.key = {.left = kEdge, .right = page.width - kEdge, .bottom = at + key, .top = at};
  page.height = at + key + kEdge;

  page.title_at = 1 - page.title_at / page.height;
  page.note_at = 1 - page.note_at / page.height;
  const auto to_shares = [&](PlotBox& box) {
    box = {box.left / page.width, box.right / page.width, 1 - box.bottom / page.height,
           1 - box.top / page.height};
  };
  std::ranges::for_each(page.panels, to_shares);
  to_shares(page.key);
  return page;
}

}  // namespace palpate::app
