#include "devices/devices.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <stdexcept>

#include "devices/mouse/mouse.hpp"
#include "devices/scripted/scripted.hpp"

namespace palpate::devices {
namespace {

/// "mouse, scripted:FILE"
std::string accepted() {
  std::string text;
  for (const Device* device : all())
    text += fmt::format("{}{}{}{}", text.empty() ? "" : ", ", device->name,
                        device->argument.empty() ? "" : ":", device->argument);
  return text;
}

}  // namespace

std::span<const Device* const> all() {
  static const std::array devices{
      &mouse(),
      &scripted(),
  };
  return devices;
}

OpenDevice open(std::string_view wanted) {
  const auto colon = wanted.find(':');
  const std::string_view name = wanted.substr(0, colon);
  const std::string argument(colon == std::string_view::npos ? std::string_view{} : wanted.substr(colon + 1));
  const auto found = std::ranges::find(all(), name, [](const Device* device) { return device->name; });
  const bool fits = found != all().end() && (colon != std::string_view::npos) == !(*found)->argument.empty();
  if (!fits)
    throw std::invalid_argument(fmt::format("\"{}\" is no device; accepted: {}", wanted, accepted()));
  return {.device = *found, .handle = (*found)->open(argument)};
}

}  // namespace palpate::devices
