#pragma once

#include <string>

#include "sim/view/picture.hpp"

namespace palpate::sim {

/// Where the bar lies in a picture [pixel].
struct ScaleBar {
  int left = 0, bottom = 0;  // of its line, from the lower left corner
  int length = 0;
  int thickness = 0;
};

/// @param height  of the picture [pixel]
ScaleBar scale_bar_of(const Picture& picture, int height);

/// "10 mm", "20 µm": in the unit, m, mm or µm, in which the number is from 1 to below 1000.
std::string length_in_words(double metres);

}  // namespace palpate::sim
