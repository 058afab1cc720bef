#include "sim/view/scale_bar.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace palpate::sim {

ScaleBar scale_bar_of(const Picture& picture, int height) {
  const double distance = (picture.camera.eye - picture.camera.target).norm();
  const double metres_high = 2 * distance * std::tan(picture.camera.field_of_view / 2);
  const int margin = height / 24;
  return {.left = margin,
          .bottom = margin,
          .length = static_cast<int>(std::lround(picture.scale_bar / metres_high * height)),
          .thickness = std::max(1, height / 240)};
}

std::string length_in_words(double metres) {
  if (metres >= 0.9995) return fmt::format("{:.3g} m", metres);
  if (metres >= 0.9995e-3) return fmt::format("{:.3g} mm", 1e3 * metres);
  return fmt::format("{:.3g} µm", 1e6 * metres);
}

}  // namespace palpate::sim
