#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace palpate::sim {

/// A picture as it is looked at: top row first, three bytes (red, green, blue; sRGB) a pixel.
struct Image {
  int width = 0;   // [pixel]
  int height = 0;  // [pixel]
  std::vector<std::uint8_t> rgb{};
};

/// The bytes of a PNG file that holds exactly these pixels.
std::string encode_png(const Image& image);

/// The bytes of a JPEG file, for frames streamed to a screen: many times faster than PNG, and not exact.
/// @param quality  1 (small) to 100 (fine)
std::string encode_jpeg(const Image& image, int quality = 90);

}  // namespace palpate::sim
