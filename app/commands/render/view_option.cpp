#include "app/commands/render/view_option.hpp"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string_view>

namespace palpate::app {
namespace {

struct NamedView {
  std::string_view name;
  double azimuth, elevation;  // [degree]
};
constexpr std::array<NamedView, 6> kViews = {{{"front", 0, 0},
                                              {"right", 90, 0},
                                              {"back", 180, 0},
                                              {"left", -90, 0},
                                              {"top", 0, 90},
                                              {"bottom", 0, -90}}};

/// A whole text that is a number.
std::optional<double> number(std::string_view text) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

sim::ViewPoint from_degrees(double azimuth, double elevation) {
  constexpr double kDegree = std::numbers::pi / 180;
  return {.azimuth = kDegree * azimuth, .elevation = kDegree * elevation};
}

}  // namespace

std::optional<sim::ViewPoint> parse_view(const std::string& view) {
  if (view == "across") return std::nullopt;
  for (const NamedView& named : kViews)
    if (view == named.name) return from_degrees(named.azimuth, named.elevation);
  if (const auto comma = view.find(','); comma != std::string::npos) {
    const auto azimuth = number(std::string_view(view).substr(0, comma));
    const auto elevation = number(std::string_view(view).substr(comma + 1));
    if (azimuth && elevation && std::abs(*azimuth) <= 360 && std::abs(*elevation) <= 90)
      return from_degrees(*azimuth, *elevation);
  }
  throw std::invalid_argument(fmt::format(
      "--view {}: accepted: across, front, right, back, left, top, bottom, or AZIMUTH,ELEVATION in "
      "degrees, -360 to 360 and -90 to 90, e.g. 30,20",
      view));
}

}  // namespace palpate::app
