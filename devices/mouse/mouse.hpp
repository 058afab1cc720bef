#pragma once

#include "devices/device/device.hpp"

namespace palpate::devices {

/// The pointer in the examinee's page: mouse, pen or touch. It knows a depth along the press and gives no
/// force; the tissue is felt by how far the pointer lags behind the hand (pseudo_haptic.hpp).
const Device& mouse();

}  // namespace palpate::devices
