#include "analysis/report/svg.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "analysis/words/words.hpp"

namespace palpate::analysis {
namespace {

// "12.5", "12": a tenth of a pixel is enough, and no "-0".
std::string px(double value) {
  const double rounded = std::round(value * 10) / 10;
  return fmt::format("{:g}", rounded == 0 ? 0.0 : rounded);
}

// Bytes of the UTF-8 character that begins at `at`; 0 where none does. Overlong forms pass: browsers refuse
// them.
std::size_t character_length(std::string_view text, std::size_t at) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char first = byte(at);
  const std::size_t length = first < 0x80   ? 1
                             : first < 0xC2 ? 0
                             : first < 0xE0 ? 2
                             : first < 0xF0 ? 3
                             : first < 0xF5 ? 4
                                            : 0;
  if (length == 0 || at + length > text.size()) return 0;
  for (std::size_t i = at + 1; i < at + length; ++i) {
    if ((byte(i) & 0xC0) != 0x80) return 0;
  }
  return length;
}

std::string tick_text(const Axis& axis, double tick) {
  const double scale = std::pow(10.0, axis.decimals), rounded = std::round(tick * scale) / scale;
  return fmt::format("{:.{}f}", rounded == 0 ? 0.0 : rounded, axis.decimals);
}

}  // namespace

std::string escape(std::string_view text) {
  std::string safe;
  safe.reserve(text.size());
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t length = character_length(text, at);
    const char c = text[at];
    if (length == 0) {
      safe += "\xEF\xBF\xBD";  // the replacement character
    } else if (c == '&') {
      safe += "&amp;";
    } else if (c == '<') {
      safe += "&lt;";
    } else if (c == '>') {
      safe += "&gt;";
    } else if (c == '"') {
      safe += "&quot;";
    } else if (c == '\'') {
      safe += "&#39;";
    } else if ((static_cast<unsigned char>(c) < 0x20 && c != '\n') || c == 0x7f) {
      safe += ' ';
    } else {
      safe += text.substr(at, length);
    }
    at += std::max<std::size_t>(1, length);
  }
  return safe;
}

double Axis::at(double value) const {
  return pixel_low + (value - low) / (high - low) * (pixel_high - pixel_low);
}

Axis nice_axis(double low, double high, int count, bool round_ends, std::string label) {
  if (!(high > low)) high = low + std::max(1.0, std::abs(low));
  const double rough = (high - low) / count, power = std::pow(10.0, std::floor(std::log10(rough)));
  double step = 10 * power;
  for (const double factor : {5.0, 2.0, 1.0}) {
    if (factor * power >= rough * (1 - 1e-9)) step = factor * power;
  }
  Axis axis{.low = low, .high = high, .label = std::move(label)};
  if (round_ends) {
    axis.low = step * std::floor(low / step + 1e-9);
    axis.high = step * std::ceil(high / step - 1e-9);
  }
  axis.decimals = std::max(0, static_cast<int>(-std::floor(std::log10(step) + 1e-9)));
  for (double i = std::ceil(axis.low / step - 1e-9); i * step <= axis.high + 1e-9 * step; ++i) {
    axis.ticks.push_back(i * step);
  }
  return axis;
}

std::string_view colour(std::size_t index) {
  constexpr std::array<std::string_view, 6> kColours{"#0072b2", "#d55e00", "#009e73",
                                                     "#aa4499", "#56b4e9", "#b8860b"};
  return kColours[index % kColours.size()];
}

std::string_view dash(std::size_t index) {
  constexpr std::array<std::string_view, 4> kDashes{"", "7 4", "2 3", "9 3 2 3"};
  return kDashes[index % kDashes.size()];
}

double room_for(const std::vector<std::string>& names, double least) {
  constexpr double kLetter = 8.4, kMargin = 20.0;  // of the widest fonts that the page names
  std::size_t longest = 0;
  for (const std::string& name : names) longest = std::max(longest, columns(name));
  return std::max(least, kMargin + kLetter * static_cast<double>(longest));
}

std::string line(double x1, double y1, double x2, double y2, std::string_view style) {
  return fmt::format("<line x1=\"{}\" y1=\"{}\" x2=\"{}\" y2=\"{}\" {}/>\n", px(x1), px(y1), px(x2), px(y2),
                     style);
}

std::string rectangle(double x, double y, double width, double height, std::string_view style) {
  return fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" {}/>\n", px(x), px(y),
                     px(std::max(0.0, width)), px(std::max(0.0, height)), style);
}

std::string circle(double x, double y, double radius, std::string_view style) {
  return fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"{}\" {}/>\n", px(x), px(y), px(radius), style);
}

std::string path(const std::vector<std::pair<double, double>>& points, bool closed, std::string_view style) {
  std::string d;
  for (const auto& [x, y] : points) d += fmt::format("{}{} {}", d.empty() ? "M" : "L", px(x), px(y));
  return fmt::format("<path d=\"{}{}\" {}/>\n", d, closed ? "Z" : "", style);
}

std::string label(double x, double y, std::string_view anchor, std::string_view text,
                  std::string_view style) {
  return fmt::format("<text x=\"{}\" y=\"{}\" text-anchor=\"{}\" {}>{}</text>\n", px(x), px(y), anchor, style,
                     escape(text));
}

std::string horizontal_axis(const Axis& axis, double y, double grid_top) {
  std::string marks;
  for (const double tick : axis.ticks) {
    marks += line(axis.at(tick), y, axis.at(tick), grid_top, "class=\"grid\"");
    marks += line(axis.at(tick), y, axis.at(tick), y + 5, "class=\"axis\"");
    marks += label(axis.at(tick), y + 19, "middle", tick_text(axis, tick), "class=\"tick\"");
  }
  marks += line(axis.pixel_low, y, axis.pixel_high, y, "class=\"axis\"");
  return marks +
         label((axis.pixel_low + axis.pixel_high) / 2, y + 38, "middle", axis.label, "class=\"name\"");
}

std::string vertical_axis(const Axis& axis, double x, double grid_right) {
  std::string marks;
  for (const double tick : axis.ticks) {
    marks += line(x, axis.at(tick), grid_right, axis.at(tick), "class=\"grid\"");
    marks += line(x - 5, axis.at(tick), x, axis.at(tick), "class=\"axis\"");
    marks += label(x - 9, axis.at(tick) + 4, "end", tick_text(axis, tick), "class=\"tick\"");
  }
  const double middle = (axis.pixel_low + axis.pixel_high) / 2;
  const std::string turn =
      fmt::format("class=\"name\" transform=\"rotate(-90 {} {})\"", px(x - 44), px(middle));
  return marks + line(x, axis.pixel_low, x, axis.pixel_high, "class=\"axis\"") +
         label(x - 44, middle, "middle", axis.label, turn);
}

std::string picture(std::string_view id, double width, double height, std::string_view title,
                    std::string_view description, const std::string& marks) {
  return fmt::format(
      "<svg role=\"img\" aria-labelledby=\"{0}-title {0}-text\" viewBox=\"0 0 {1} {2}\" width=\"{1}\" "
      "height=\"{2}\">\n<title id=\"{0}-title\">{3}</title>\n<desc id=\"{0}-text\">{4}</desc>\n{5}</svg>\n",
      id, px(width), px(height), escape(title), escape(description), marks);
}

}  // namespace palpate::analysis
