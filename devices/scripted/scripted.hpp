#pragma once

#include "devices/device/device.hpp"

namespace palpate::devices {

/// A hand that follows a path from a CSV file (path.hpp), in the time of the interval: the same cycles of the
/// loop meet the same places, whatever the clock does. It moves the first probe and starts anew with each
/// interval, off the skin as any hand must.
const Device& scripted();

}  // namespace palpate::devices
