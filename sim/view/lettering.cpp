#include "sim/view/lettering.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <vector>

#include "sim/view/freetype.hpp"

namespace palpate::sim {
namespace {

constexpr const char* kFont = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf";

/// Code points of a text in UTF-8; a byte that is none of it gives the replacement character.
std::vector<char32_t> code_points(std::string_view text) {
  std::vector<char32_t> points;
  for (std::size_t i = 0; i < text.size();) {
    const auto first = static_cast<unsigned char>(text[i]);
    const std::size_t length = first < 0x80 ? 1 : first < 0xC2 ? 0 : first < 0xE0 ? 2 : first < 0xF0 ? 3 : 4;
    if (length == 0 || i + length > text.size()) {
      points.push_back(U'\uFFFD');
      ++i;
      continue;
    }
    char32_t point = length == 1 ? first : first & (0x7FU >> length);
    for (std::size_t k = 1; k < length; ++k)
      point = (point << 6U) | (static_cast<unsigned char>(text[i + k]) & 0x3FU);
    points.push_back(point);
    i += length;
  }
  return points;
}

void blend(Image& image, int x, int y, const Colour& colour, double share) {
  if (x < 0 || y < 0 || x >= image.width || y >= image.height) return;
  std::uint8_t* pixel =
      image.rgb.data() +
      3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x));
  const float parts[] = {colour.red, colour.green, colour.blue};
  for (std::size_t k = 0; k < 3; ++k)
    pixel[k] = static_cast<std::uint8_t>(std::lround((1 - share) * pixel[k] + share * 255.0 * parts[k]));
}

}  // namespace

struct Lettering::Face {
  const FreeType& library = freetype();
  FT_Face face = nullptr;
  int size = 0;
  ~Face() {
    if (face != nullptr) library.done_face(face);
  }
};

Lettering::Lettering(int size) : face_(new Face) {
  face_->size = size;
  if (face_->library.new_face(face_->library.library, kFont, 0, &face_->face) != 0)
    throw std::runtime_error(fmt::format(
        "no words can be drawn: {} cannot be read; it is in the package fonts-dejavu-core", kFont));
  if (face_->library.set_pixel_sizes(face_->face, 0, static_cast<FT_UInt>(size)) != 0)
    throw std::runtime_error(fmt::format("no words can be drawn: no letters of {} pixels", size));
}

Lettering::~Lettering() = default;

int Lettering::size() const {
  return face_->size;
}

int Lettering::width(std::string_view text) const {
  long width = 0;
  for (const char32_t point : code_points(text))
    if (face_->library.load_char(face_->face, point, FT_LOAD_DEFAULT) == 0)
      width += face_->face->glyph->advance.x / 64;
  return static_cast<int>(width);
}

void Lettering::write(Image& image, std::string_view text, int left, int baseline,
                      const Colour& colour) const {
  int pen = left;
  for (const char32_t point : code_points(text)) {
    if (face_->library.load_char(face_->face, point, FT_LOAD_RENDER) != 0) continue;
    const FT_GlyphSlot glyph = face_->face->glyph;
    const FT_Bitmap& letter = glyph->bitmap;  // one byte a pixel: the share that the letter covers
    for (int y = 0; y < static_cast<int>(letter.rows); ++y)
      for (int x = 0; x < static_cast<int>(letter.width); ++x)
        blend(image, pen + glyph->bitmap_left + x, baseline - glyph->bitmap_top + y, colour,
              letter.buffer[y * letter.pitch + x] / 255.0);
    pen += static_cast<int>(glyph->advance.x / 64);
  }
}

}  // namespace palpate::sim
