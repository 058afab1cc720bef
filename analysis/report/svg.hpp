#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace palpate::analysis {

// Pictures as SVG text, to stand inside an HTML page. Lengths are pixels of the picture, y runs downward.

/// Text from a file made harmless inside HTML and SVG: & < > " ' become entities, control characters a space,
/// bytes that are no UTF-8 the replacement character.
std::string escape(std::string_view text);

/// A scale along one side of a picture.
struct Axis {
  double low = 0.0, high = 1.0;              // in the data's unit
  double pixel_low = 0.0, pixel_high = 1.0;  // where these two lie; pixel_high < pixel_low for an upward axis
  std::vector<double> ticks{};
  int decimals = 0;  // that the ticks need
  std::string label{};

  double at(double value) const;  // pixel of a value
};

/// An axis from `low` to `high`, with about `count` ticks at 1, 2 or 5 times a power of ten; its ends are
/// moved outward to ticks where `round_ends`. An empty range is widened.
Axis nice_axis(double low, double high, int count, bool round_ends, std::string label);

/// Colours that people with any kind of colour vision tell apart (Okabe & Ito 2008), dark enough for lines.
std::string_view colour(std::size_t index);
/// Dashes that go with them, so that lines differ on grey paper too; "" is a solid line.
std::string_view dash(std::size_t index);

/// Room for names at the left of a picture, set in 14 pixels: `least`, or what the longest of them takes.
double room_for(const std::vector<std::string>& names, double least);

// Each returns one element; `style` is the name of a CSS class or further attributes ('class="grid"').
std::string line(double x1, double y1, double x2, double y2, std::string_view style);
std::string rectangle(double x, double y, double width, double height, std::string_view style);
std::string circle(double x, double y, double radius, std::string_view style);
std::string path(const std::vector<std::pair<double, double>>& points, bool closed, std::string_view style);
/// `anchor` is start, middle or end; the text is escaped.
std::string label(double x, double y, std::string_view anchor, std::string_view text,
                  std::string_view style = "");

/// Ticks, their numbers and the name of a horizontal axis at height y; grid lines up to `grid_top`.
std::string horizontal_axis(const Axis& axis, double y, double grid_top);
/// The same at the left of a picture, grid lines to `grid_right`.
std::string vertical_axis(const Axis& axis, double x, double grid_right);

/// A whole picture with a title and a description for those who cannot see it; `id` is unique in the page.
std::string picture(std::string_view id, double width, double height, std::string_view title,
                    std::string_view description, const std::string& marks);

}  // namespace palpate::analysis
