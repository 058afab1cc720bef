#include "sim/view/paint.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "sim/cycle/press.hpp"
#include "sim/view/annotate.hpp"
#include "sim/view/colour_map.hpp"
#include "sim/view/cut.hpp"
#include "sim/view/lettering.hpp"
#include "sim/view/picture_of.hpp"
#include "sim/view/scale_bar.hpp"
#include "tests/sim/support/two_boxes.hpp"

namespace palpate::sim {
namespace {

using test::compile_scene;
using test::write_two_boxes;

/// CIE lightness of an sRGB colour. Source: IEC 61966-2-1 and CIE 15.
double lightness(const Colour& colour) {
  const auto linear = [](double part) {
    return part <= 0.04045 ? part / 12.92 : std::pow((part + 0.055) / 1.055, 2.4);
  };
  const double y = 0.2126 * linear(colour.red) + 0.7152 * linear(colour.green) + 0.0722 * linear(colour.blue);
  return y > 0.008856 ? 116 * std::cbrt(y) - 16 : 903.3 * y;
}

TEST(Viridis, LightnessRisesInEqualSteps) {
  const double dark = lightness(viridis(0.0)), bright = lightness(viridis(1.0));
  EXPECT_NEAR(dark, 15, 2);  // #440154 and #fde725
  EXPECT_NEAR(bright, 91, 2);
  for (double share = 0.0; share <= 1.0; share += 0.05)
    EXPECT_NEAR(lightness(viridis(share)), dark + share * (bright - dark), 2.0) << share;
  EXPECT_EQ(viridis(-1).red, viridis(0).red);
  EXPECT_EQ(viridis(7).green, viridis(1).green);
}

/// Two boxes whose every node has moved by H x + shift.
struct Moved {
  Model model = compile_scene(write_two_boxes());
  Picture picture;
  std::vector<WholeBody> bodies;

  Moved(const Eigen::Matrix3d& gradient, const Vec3& shift) {
    const std::vector<ProbeDisplacement> rest = displaced_by(model, 0.0);
    Simulation simulation(model);
    simulation.step(rest, kCyclePeriod);
    picture = picture_of(model, set_stage(model, 4.0 / 3), simulation.loads(), rest);
    for (const Body& body : model.bodies) {
      WholeBody& whole = bodies.emplace_back();
      whole.displacement.resize(3, static_cast<Eigen::Index>(body.mesh->nodes.size()));
      for (std::size_t i = 0; i < body.mesh->nodes.size(); ++i)
        whole.displacement.col(static_cast<Eigen::Index>(i)) = gradient * body.mesh->nodes[i] + shift;
    }
  }
};

TEST(Paint, ABarUnderTensionHasOneStressWhichIsModulusTimesStrain) {
  Moved moved(Eigen::Matrix3d::Zero(), Vec3::Zero());
  double largest = 0.0, smallest = INFINITY;
  for (std::size_t b = 0; b < moved.bodies.size(); ++b) {
    const Material& material = moved.model.bodies[b].materials.front();
    const double strain = 1e-3, nu = material.poisson_ratio;
    const Eigen::Matrix3d pull = Vec3(strain, -nu * strain, -nu * strain).asDiagonal().toDenseMatrix();
    for (std::size_t i = 0; i < moved.model.bodies[b].mesh->nodes.size(); ++i)
      moved.bodies[b].displacement.col(static_cast<Eigen::Index>(i)) =
          pull * moved.model.bodies[b].mesh->nodes[i];
    largest = std::max(largest, material.young_modulus * strain);
    smallest = std::min(smallest, material.young_modulus * strain);
  }
  const Legend legend = paint(moved.picture, moved.model, moved.bodies, Field::Stress);
  const double unit = legend.unit == "kPa" ? 1e3 : legend.unit == "Pa" ? 1.0 : 1e6;
  EXPECT_NEAR(legend.most * unit / largest, 1.0, 1e-9);
  EXPECT_NEAR(legend.least * unit / smallest, 1.0, 1e-9);
}

TEST(Paint, ARigidMotionHasNoStress) {
  Eigen::Matrix3d turn = Eigen::Matrix3d::Zero();
  turn(0, 1) = -0.01, turn(1, 0) = 0.01;
  Moved moved(turn, Vec3(1e-3, 2e-3, 0));
  const Legend legend = paint(moved.picture, moved.model, moved.bodies, Field::Stress);
  EXPECT_EQ(legend.unit, "Pa");
  EXPECT_LT(legend.most, 1e-9 * moved.model.bodies[0].young_modulus);
}

TEST(Paint, DisplacementIsItsLengthInAUnitThatFits) {
  Moved moved(Eigen::Matrix3d::Zero(), Vec3(3e-4, 0, -4e-4));
  const Legend legend = paint(moved.picture, moved.model, moved.bodies, Field::Displacement);
  EXPECT_EQ(legend.unit, "µm");
  EXPECT_NEAR(legend.least, 500, 1e-9);
  EXPECT_NEAR(legend.most, 500, 1e-9);
  for (WholeBody& whole : moved.bodies) whole.displacement *= 2;
  EXPECT_EQ(paint(moved.picture, moved.model, moved.bodies, Field::Displacement).unit, "mm");
}

TEST(Paint, ColoursRunFromTheLeastToTheMost) {
  Eigen::Matrix3d gradient = Eigen::Matrix3d::Zero();
  gradient(0, 0) = 0.01;
  Moved moved(gradient, Vec3(1, 0, 0));  // all the same sign
  paint(moved.picture, moved.model, moved.bodies, Field::Displacement);
  double least = INFINITY, most = 0.0;
  for (const WholeBody& whole : moved.bodies) {
    least = std::min(least, whole.displacement.colwise().norm().minCoeff());
    most = std::max(most, whole.displacement.colwise().norm().maxCoeff());
  }
  for (std::size_t b = 0; b < moved.bodies.size(); ++b) {
    const DrawnBody& drawn = moved.picture.bodies[b];
    EXPECT_EQ(drawn.opacity, 1.0F);
    ASSERT_EQ(drawn.corner_colours.cols(), 3 * std::ssize(drawn.triangles));
    for (std::size_t t = 0; t < drawn.triangles.size(); ++t) {
      const double value = moved.bodies[b].displacement.col(drawn.triangles[t][1]).norm();
      const Colour colour = viridis((value - least) / (most - least));
      EXPECT_NEAR(drawn.corner_colours(0, static_cast<Eigen::Index>(3 * t + 1)), colour.red, 1e-6);
    }
  }
}

TEST(CutOpen, LeavesWhatLiesBehindThePress) {
  Moved moved(Eigen::Matrix3d::Zero(), Vec3::Zero());
  cut_open(moved.picture, moved.model, moved.bodies);
  const Probe& probe = moved.model.probes.front();
  const Vec3 back = (moved.picture.camera.eye - moved.picture.camera.target).normalized();
  const Vec3 normal = (back - back.dot(probe.direction) * probe.direction).normalized();
  for (std::size_t b = 0; b < moved.bodies.size(); ++b) {
    const TetMesh& mesh = *moved.model.bodies[b].mesh;
    const DrawnBody& drawn = moved.picture.bodies[b];
    ASSERT_FALSE(drawn.triangles.empty());
    EXPECT_LT(drawn.triangles.size(), moved.model.bodies[b].surface->triangles.size());
    for (std::size_t t = 0; t < drawn.triangles.size(); ++t) {
      Vec3 middle = Vec3::Zero();
      for (const int node : mesh.tetrahedra[drawn.behind[t]]) middle += mesh.nodes[node] / 4;
      EXPECT_LE((middle - probe.at).dot(normal), 1e-12);
      for (const int node : drawn.triangles[t])
        EXPECT_EQ(std::ranges::count(mesh.tetrahedra[drawn.behind[t]], node), 1);
    }
  }
  moved.picture.camera.eye = moved.picture.camera.target - probe.direction;
  EXPECT_THROW(cut_open(moved.picture, moved.model, moved.bodies), std::invalid_argument);
}

TEST(LengthInWords, IsInTheUnitThatFits) {
  EXPECT_EQ(length_in_words(0.010), "10 mm");
  EXPECT_EQ(length_in_words(0.5), "500 mm");
  EXPECT_EQ(length_in_words(2), "2 m");
  EXPECT_EQ(length_in_words(20e-6), "20 µm");
  EXPECT_EQ(length_in_words(1e-3), "1 mm");
}

/// Pixels of a part of an image that are not white.
int dark(const Image& image, int left, int top, int right, int bottom) {
  int count = 0;
  for (int y = top; y < bottom; ++y)
    for (int x = left; x < right; ++x)
      count += image.rgb[3 * static_cast<std::size_t>(y * image.width + x)] < 128;
  return count;
}

Image blank(int width, int height) {
  return {.width = width, .height = height, .rgb = std::vector<std::uint8_t>(3UL * width * height, 255)};
}

TEST(Lettering, WritesWhereItIsTold) {
  const Lettering letters(20);
  Image image = blank(200, 60);
  letters.write(image, "10 mm", 50, 40, {0, 0, 0});
  const int width = letters.width("10 mm");
  EXPECT_GT(dark(image, 50, 20, 50 + width, 41), 100);
  EXPECT_EQ(dark(image, 0, 0, 200, 60), dark(image, 49, 24, 51 + width, 42));  // nothing elsewhere
  EXPECT_GT(letters.width("µ"), 0);
  EXPECT_EQ(letters.width("µ") * 2, letters.width("µµ"));
  Image small = blank(8, 8);
  letters.write(small, "far outside", -40, 3, {0, 0, 0});  // what lies outside is left out
  letters.write(small, "\xff\xc3", 0, 8, {0, 0, 0});       // no UTF-8
}

TEST(Annotated, HasANumberAtTheBarAndTheLegendAtTheRight) {
  Picture picture{.scale_bar = 0.01};
  picture.camera.eye = Vec3(0, 0, 0.1);
  const Image drawn = blank(640, 480);
  const ScaleBar bar = scale_bar_of(picture, 480);
  const Image words = annotated(drawn, picture, std::nullopt);
  EXPECT_EQ(words.width, 640);
  EXPECT_GT(dark(words, bar.left, 420, bar.left + bar.length, 480 - bar.bottom), 30);

  const Legend legend{.title = "displacement", .unit = "mm", .least = 0, .most = 5};
  const Image with = annotated(drawn, picture, legend);
  EXPECT_EQ(with.width, 640 + legend_width(480));
  const int x = 640 + 11 + 3;  // within the bar: letters are 480 / 42 = 11 pixels high
  const auto colour = [&](int y) { return &with.rgb[3 * static_cast<std::size_t>(y * with.width + x)]; };
  EXPECT_NEAR(colour(5 * 11 + 1)[0], 253, 3);       // yellow above
  EXPECT_NEAR(colour(480 - 3 * 11 - 2)[2], 84, 3);  // violet below
}

}  // namespace
}  // namespace palpate::sim
