#pragma once

#include "devices/device/device.hpp"

namespace palpate::devices {

/// A hand that goes 2 mm in and out once a second: no person's, for trying a loop.
const Device& sine();

}  // namespace palpate::devices
