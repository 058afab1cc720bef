#include "sim/view/renderer.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <random>
#include <stdexcept>

#include "tests/sim/support/ball.hpp"

namespace palpate::sim {
namespace {

using test::ball;

constexpr int kWidth = 320, kHeight = 240;
constexpr double kDistance = 5.0, kFieldOfView = 0.6;

Picture picture_with(std::vector<DrawnBody> bodies) {
  Picture picture{.bodies = std::move(bodies)};
  picture.camera = {.eye = Vec3(0, 0, kDistance), .field_of_view = kFieldOfView};
  return picture;
}

Image render(const Picture& picture) {
  return Renderer(kWidth, kHeight).render(picture);
}

std::array<int, 3> pixel(const Image& image, int x, int y) {
  const std::size_t at = 3 * static_cast<std::size_t>(y * image.width + x);
  return {image.rgb[at], image.rgb[at + 1], image.rgb[at + 2]};
}

constexpr std::array<int, 3> kBackground = {250, 250, 247};  // Picture's own, times 255

int largest_difference(const Image& a, const Image& b) {
  int largest = 0;
  for (std::size_t i = 0; i < a.rgb.size(); ++i) largest = std::max(largest, std::abs(a.rgb[i] - b.rgb[i]));
  return largest;
}

/// How many pixels of a row (or a column) differ from the background, partly covered ones by their share.
double extent(const Image& image, bool row) {
  double sum = 0.0;
  const int count = row ? image.width : image.height;
  for (int i = 0; i < count; ++i) {
    const auto p = row ? pixel(image, i, image.height / 2) : pixel(image, image.width / 2, i);
    sum += p == kBackground ? 0.0 : 1.0;
  }
  return sum;
}

TEST(Renderer, DrawsABallOverTheBackground) {
  const Image image = render(picture_with({ball({0, 0, 0}, 1.0F, 3)}));
  ASSERT_EQ(image.rgb.size(), 3U * kWidth * kHeight);
  const auto [red, green, blue] = pixel(image, kWidth / 2, kHeight / 2);
  EXPECT_GT(red, 2 * green);
  EXPECT_GT(red, 2 * blue);
  for (const int x : {0, kWidth - 1})
    for (const int y : {0, kHeight - 1}) EXPECT_EQ(pixel(image, x, y), kBackground);
}

TEST(Renderer, OutlineOfABallIsItsPerspectiveProjection) {
  // The cone of tangents from the eye has the half angle asin(R / D).
  const double radius = std::tan(std::asin(1.0 / kDistance)) / std::tan(kFieldOfView / 2) * kHeight / 2;
  const Image image = render(picture_with({ball({0, 0, 0}, 1.0F, 5)}));
  EXPECT_NEAR(extent(image, true) / 2, radius, 1.0);
  EXPECT_NEAR(extent(image, false) / 2, radius, 1.0);
}

TEST(Renderer, RightIsRightAndUpIsUp) {
  const Image image = render(picture_with({ball({0.8F, 0.5F, 0}, 0.2F, 2)}));
  const double scale =
      kHeight / 2 / (kDistance * std::tan(kFieldOfView / 2));  // pixels a metre at the target
  const auto x = static_cast<int>(kWidth / 2 + 0.8 * scale), y = static_cast<int>(kHeight / 2 - 0.5 * scale);
  EXPECT_NE(pixel(image, x, y), kBackground);
  EXPECT_EQ(pixel(image, kWidth - 1 - x, y), kBackground);
  EXPECT_EQ(pixel(image, x, kHeight - 1 - y), kBackground);
}

TEST(Renderer, SamePictureGivesTheSameBits) {
  DrawnBody glass = ball({0, 0, 0}, 1.0F, 3);
  glass.opacity = 0.4F;
  const Picture picture = picture_with({glass, ball({0.3F, 0, 0}, 0.4F, 3)});
  Renderer renderer(kWidth, kHeight);
  const Image first = renderer.render(picture);
  renderer.render(picture_with({ball({0, 0, 0}, 2.0F, 1)}));
  EXPECT_EQ(renderer.render(picture).rgb, first.rgb);
  EXPECT_EQ(render(picture).rgb, first.rgb);
}

TEST(Renderer, TranslucencyDoesNotDependOnTheOrderOfTriangles) {
  std::mt19937 random(7);
  DrawnBody outer = ball({0, 0, 0}, 1.0F, 3), inner = ball({0.1F, 0, 0}, 0.6F, 3);
  outer.opacity = 0.4F;
  inner.opacity = 0.5F;
  inner.colour = {0.1F, 0.3F, 0.9F};
  const Image first = render(picture_with({outer, inner}));
  for (int repeat = 0; repeat < 3; ++repeat) {
    std::ranges::shuffle(outer.triangles, random);
    std::ranges::shuffle(inner.triangles, random);
    // Normals are sums in another order: round-off may change a level.
    EXPECT_LE(largest_difference(render(picture_with({inner, outer})), first), 1);
  }
}

TEST(Renderer, WhatIsBehindShowsThroughATranslucentBodyOnly) {
  const DrawnBody inside = ball({0, 0, 0}, 0.5F, 3);
  DrawnBody outside = ball({0, 0, 0}, 1.0F, 3);
  outside.colour = {0.2F, 0.3F, 0.9F};
  const Image solid = render(picture_with({outside}));
  EXPECT_EQ(render(picture_with({outside, inside})).rgb, solid.rgb);
  outside.opacity = 0.4F;
  const int alone = pixel(render(picture_with({outside})), kWidth / 2, kHeight / 2)[1];
  const Image through = render(picture_with({outside, inside}));
  EXPECT_LT(pixel(through, kWidth / 2, kHeight / 2)[1],
            alone - 20);  // red lets less green through than white
}

TEST(Renderer, OpacityRunsFromNothingToSolid) {
  DrawnBody body = ball({0, 0, 0}, 1.0F, 3);
  std::vector<int> green;
  for (const float opacity : {0.0F, 0.2F, 0.4F, 0.6F, 0.8F, 1.0F}) {
    body.opacity = opacity;
    green.push_back(pixel(render(picture_with({body})), kWidth / 2, kHeight / 2)[1]);
  }
  EXPECT_EQ(green.front(), kBackground[1]);
  EXPECT_TRUE(std::ranges::is_sorted(green, std::greater<>())) << testing::PrintToString(green);
}

TEST(Renderer, ProbeIsARoundRodFromItsTouchTowardsTheHand) {
  Picture picture = picture_with({});
  picture.probes = {{.touch = Vec3(0, 0, 0),
                     .direction = Vec3(-1, 0, 0),
                     .shaft = Vec3(1, 0, 0),
                     .radius = 0.2,
                     .length = 0.8,
                     .colour = {0.5F, 0.5F, 0.5F}}};
  const Image image = render(picture);
  const double scale = kHeight / 2 / (kDistance * std::tan(kFieldOfView / 2));
  const auto at = [&](double x, double y) {
    return pixel(image, static_cast<int>(kWidth / 2 + x * scale), static_cast<int>(kHeight / 2 - y * scale));
  };
  for (const double x : {0.04, 0.6, 1.16}) EXPECT_NE(at(x, 0), kBackground) << x;
  for (const double x : {-0.04, 1.26}) EXPECT_EQ(at(x, 0), kBackground) << x;
  EXPECT_NE(at(0.6, 0.18), kBackground);
  EXPECT_EQ(at(0.6, 0.24), kBackground);
}

TEST(Renderer, ScaleBarIsTrueAtTheTarget) {
  Picture picture = picture_with({});
  picture.scale_bar = 1.0;
  const Image image = render(picture);
  int dark = 0;
  for (int y = 0; y < kHeight; ++y) {
    int here = 0;
    for (int x = 0; x < kWidth; ++x) here += pixel(image, x, y)[0] < 128 ? 1 : 0;
    dark = std::max(dark, here);
  }
  EXPECT_NEAR(dark, kHeight / (2 * kDistance * std::tan(kFieldOfView / 2)), 1.0);
}

TEST(Renderer, RefusesSizesAndCamerasThatShowNothing) {
  EXPECT_THROW(Renderer(8, 100), std::invalid_argument);
  EXPECT_THROW(Renderer(100, 10000), std::invalid_argument);
  Picture picture = picture_with({});
  picture.camera.up = Vec3::UnitZ();
  EXPECT_THROW(render(picture), std::invalid_argument);
}

}  // namespace
}  // namespace palpate::sim
