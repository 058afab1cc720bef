#pragma once

#include <span>
#include <string>
#include <string_view>

#include "devices/device/device.hpp"

namespace palpate::devices {

/// Every kind of device, each once; the first is what a session has when none is named.
std::span<const Device* const> all();

/// Opens "NAME" or "NAME:ARGUMENT". Throws std::invalid_argument that says what was found and what is
/// accepted, or why the device refuses its argument.
OpenDevice open(std::string_view wanted);

}  // namespace palpate::devices
