#pragma once

#include <optional>
#include <string>

#include "sim/view/picture_of.hpp"

namespace palpate::app {

/// What --view asks for: across (the press; nothing is returned), front, back, left, right, top, bottom, or
/// AZIMUTH,ELEVATION in degrees. Throws std::invalid_argument.
std::optional<sim::ViewPoint> parse_view(const std::string& view);

}  // namespace palpate::app
