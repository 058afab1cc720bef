#include "sim/view/annotate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sim/view/colour_map.hpp"
#include "sim/view/lettering.hpp"
#include "sim/view/scale_bar.hpp"

namespace palpate::sim {
namespace {

constexpr Colour kInk{0.20F, 0.20F, 0.22F};

/// Three digits, and no power of ten for thousands.
std::string number(double value) {
  return std::abs(value) < 999.5 ? fmt::format("{:.3g}", value) : fmt::format("{:.0f}", value);
}

int letters_of(int height) {
  return std::clamp(height / 42, 9, 60);  // [pixel]
}

void fill(Image& image, int left, int top, int width, int height, const Colour& colour) {
  const auto part = [](float value) { return static_cast<std::uint8_t>(std::lround(255 * value)); };
  for (int y = std::max(top, 0); y < std::min(top + height, image.height); ++y)
    for (int x = std::max(left, 0); x < std::min(left + width, image.width); ++x) {
      std::uint8_t* pixel = image.rgb.data() + 3 * (static_cast<std::size_t>(y) * image.width + x);
      pixel[0] = part(colour.red), pixel[1] = part(colour.green), pixel[2] = part(colour.blue);
    }
}

/// In the ink, with an edge of the background's colour: it can be read over a body too.
void write_clear(Image& image, const Lettering& letters, const std::string& text, int left, int baseline,
                 const Colour& background) {
  const int edge = std::max(1, letters.size() / 12);
  for (int dy = -edge; dy <= edge; ++dy)
    for (int dx = -edge; dx <= edge; ++dx) letters.write(image, text, left + dx, baseline + dy, background);
  letters.write(image, text, left, baseline, kInk);
}

void label_bar(Image& image, const Picture& picture, const Lettering& letters) {
  const ScaleBar bar = scale_bar_of(picture, image.height);
  const std::string text = length_in_words(picture.scale_bar);
  const int left = std::max(bar.left, bar.left + (bar.length - letters.width(text)) / 2);
  write_clear(image, letters, text, left, image.height - bar.bottom - 4 * bar.thickness - letters.size() / 4,
              picture.background);
}

/// Round values strictly between the ends, at which the scale has numbers too; not so near that they touch.
std::vector<double> ticks_of(const Legend& legend) {
  const double range = legend.most - legend.least;
  if (!(range > 0)) return {};
  const double power = std::pow(10.0, std::floor(std::log10(range / 4)));
  double step = 10 * power;
  for (const double factor : {5.0, 2.0})
    if (factor * power >= range / 4) step = factor * power;
  std::vector<double> ticks;
  for (double i = std::ceil(legend.least / step); i * step < legend.most; ++i)
    if (i * step > legend.least + 0.07 * range && i * step < legend.most - 0.07 * range)
      ticks.push_back(i * step);
  return ticks;
}

void draw_legend(Image& image, int left, const Legend& legend, const Lettering& letters) {
  const int size = letters.size(), wide = 3 * size / 2, bar_left = left + size;
  const int top = 5 * size, high = image.height - top - 3 * size;
  letters.write(image, legend.title, bar_left, 2 * size, kInk);
  letters.write(image, fmt::format("[{}]", legend.unit), bar_left, 2 * size + 5 * size / 4, kInk);
  const bool uniform = !(legend.most > legend.least);
  for (int y = 0; y < high; ++y)
    fill(image, bar_left, top + y, wide, 1, viridis(uniform ? 0.0 : 1.0 - (y + 0.5) / high));
  const auto mark = [&](double share, const std::string& text) {
    const int at = top + static_cast<int>(std::lround((1 - share) * (high - 1)));
    fill(image, bar_left + wide, at, size / 2, std::max(1, size / 12), kInk);
    letters.write(image, text, bar_left + wide + 3 * size / 4, at + 3 * size / 8, kInk);
  };
  if (uniform) return mark(0.5, number(legend.least));
  mark(0.0, number(legend.least));
  mark(1.0, number(legend.most));
  for (const double tick : ticks_of(legend))
    mark((tick - legend.least) / (legend.most - legend.least), number(tick));
}

}  // namespace

int legend_width(int height) {
  return 11 * letters_of(height);
}

Image annotated(const Image& drawn, const Picture& picture, const std::optional<Legend>& legend) {
  const Lettering letters(letters_of(drawn.height));
  Image image = drawn;
  if (picture.scale_bar > 0) label_bar(image, picture, letters);
  if (!legend) return image;
  Image wider{.width = drawn.width + legend_width(drawn.height), .height = drawn.height};
  wider.rgb.resize(3 * static_cast<std::size_t>(wider.width) * static_cast<std::size_t>(wider.height));
  fill(wider, 0, 0, wider.width, wider.height, picture.background);
  for (int y = 0; y < image.height; ++y)
    std::copy_n(image.rgb.begin() + 3L * y * image.width, 3L * image.width,
                wider.rgb.begin() + 3L * y * wider.width);
  draw_legend(wider, image.width, *legend, letters);
  return wider;
}

}  // namespace palpate::sim
