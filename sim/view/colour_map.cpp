#include "sim/view/colour_map.hpp"

#include <algorithm>
#include <array>

namespace palpate::sim {
namespace {

/// Entries 0, 28, 57, ..., 255 of Matplotlib's table of 256, red in the highest byte.
constexpr std::array<unsigned, 10> kViridis = {0x440154, 0x482878, 0x3e4989, 0x31688e, 0x26828e,
                                               0x1f9e89, 0x35b779, 0x6ece58, 0xb5de2b, 0xfde725};

Colour colour_of(unsigned rgb) {
  const auto part = [&](unsigned shift) { return static_cast<float>((rgb >> shift) & 0xffU) / 255.0F; };
  return {part(16), part(8), part(0)};
}

}  // namespace

Colour viridis(double share) {
  const double at = std::clamp(share, 0.0, 1.0) * (kViridis.size() - 1);
  const auto low = std::min(static_cast<std::size_t>(at), kViridis.size() - 2);
  const auto t = static_cast<float>(at - static_cast<double>(low));
  const Colour a = colour_of(kViridis[low]), b = colour_of(kViridis[low + 1]);
  return {a.red + t * (b.red - a.red), a.green + t * (b.green - a.green), a.blue + t * (b.blue - a.blue)};
}

}  // namespace palpate::sim
