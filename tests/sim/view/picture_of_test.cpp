#include "sim/view/picture_of.hpp"

#include <gmock/gmock.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <filesystem>

#include "sim/cycle/press.hpp"
#include "tests/sim/support/two_boxes.hpp"
#include "tests/support/places.hpp"

namespace palpate::sim {
namespace {

using test::compile_scene;
using test::write_two_boxes;

constexpr double kAspect = 4.0 / 3.0;

Model palpation(const char* scene) {
  return compile_scene(std::filesystem::path(palpate::test::source_folder()) / "data/scenes" / scene);
}

Model rectal_palpation() {
  return palpation("rectal-palpation.toml");
}

Picture pressed(const Model& model, double depth) {
  const std::vector<ProbeDisplacement> pose = displaced_by(model, depth);
  Simulation simulation(model);
  EXPECT_EQ(simulation.step(pose, kCyclePeriod).solve.stop, Stop::Converged);
  return picture_of(model, set_stage(model, kAspect), simulation.loads(), pose);
}

TEST(PictureOf, ShowsEveryBodyAtRest) {
  const Model model = compile_scene(write_two_boxes());
  const Picture picture = pressed(model, 0.0);
  ASSERT_EQ(picture.bodies.size(), 2U);
  for (std::size_t b = 0; b < 2; ++b) {
    EXPECT_EQ(picture.bodies[b].name, model.bodies[b].name);
    for (std::size_t i = 0; i < model.bodies[b].mesh->nodes.size(); ++i)
      EXPECT_EQ(picture.bodies[b].positions.col(static_cast<Eigen::Index>(i)),
                model.bodies[b].mesh->nodes[i].cast<float>());
  }
}

TEST(PictureOf, HeldNodeGoesWithTheProbeAndFixedNodesStay) {
  const Model model = compile_scene(write_two_boxes());
  const double depth = 1e-3;
  const Picture picture = pressed(model, depth);
  const Probe& probe = model.probes.front();
  const std::size_t pressed_body = probe.body;
  const int held = model.bodies[pressed_body].compliance->touch[probe.nodes.front()];
  const Vec3 expected = probe.at + depth * probe.direction;
  // 1e-5 of the depth: pictures are made in single precision
  EXPECT_LT((picture.bodies[pressed_body].positions.col(held).cast<double>() - expected).norm(),
            1e-5 * depth);
  EXPECT_LT((picture.probes.front().touch - expected).norm(), 1e-15);
  for (std::size_t b = 0; b < 2; ++b)
    for (const int node : model.bodies[b].fixed)
      EXPECT_EQ(picture.bodies[b].positions.col(node), model.bodies[b].mesh->nodes[node].cast<float>());
}

TEST(PictureOf, PressedBodyIsTranslucentWhileThereAreOthers) {
  const std::filesystem::path scene = write_two_boxes();
  const Picture both = pressed(compile_scene(scene), 0.0);
  EXPECT_EQ(std::ranges::count_if(both.bodies, [](const DrawnBody& body) { return body.opacity < 1; }), 1);
  const Override alone[] = {{"bodies.lower.present", "false"}};
  const Picture one = pressed(compile_scene(scene, alone), 0.0);
  ASSERT_EQ(one.bodies.size(), 1U);
  EXPECT_EQ(one.bodies[0].opacity, 1.0F);
}

TEST(SetStage, EveryNodeIsInThePictureAndFillsIt) {
  for (const Model& model : {rectal_palpation(), compile_scene(write_two_boxes())}) {
    const Camera camera = set_stage(model, kAspect).camera;
    const Vec3 back = (camera.eye - camera.target).normalized(), right = camera.up.cross(back).normalized();
    const double half = std::tan(camera.field_of_view / 2);
    double widest = 0.0;  // in half pictures
    for (const Body& body : model.bodies)
      for (const int node : body.surface->nodes) {
        const Vec3 p = body.mesh->nodes[node] - camera.eye;
        ASSERT_GT(-back.dot(p), 0.0);
        const double x = std::abs(right.dot(p)) / -back.dot(p) / (half * kAspect);
        const double y = std::abs(back.cross(right).dot(p)) / -back.dot(p) / half;
        widest = std::max({widest, x, y});
      }
    EXPECT_LT(widest, 0.95);
    EXPECT_GT(widest, 0.70);  // no body lost in a wide margin
  }
}

TEST(SetStage, ProbeIsHeldFromWhereNothingIsInItsWay) {
  const Model boxes = compile_scene(write_two_boxes());
  EXPECT_LT((set_stage(boxes, kAspect).probes.front().shaft + boxes.probes.front().direction).norm(), 1e-12);

  const Model organs = rectal_palpation();  // a finger inside a tube: it leaves by an end
  const Stage stage = set_stage(organs, kAspect);
  const ProbeShape& shape = stage.probes.front();
  const Vec3 end = organs.probes.front().at - shape.radius * organs.probes.front().direction;
  EXPECT_GT(shape.length, 0.02);
  for (const Body& body : organs.bodies)
    for (const int node : body.surface->nodes) {
      const Vec3 from_end = body.mesh->nodes[node] - end;
      const Vec3 nearest = std::clamp(from_end.dot(shape.shaft), 0.0, shape.length) * shape.shaft;
      EXPECT_GE((from_end - nearest).norm(), 0.999 * shape.radius);
    }
}

TEST(SetStage, LooksAtACoarseAndAFineMeshFromOnePlace) {
  const Stage coarse = set_stage(rectal_palpation(), kAspect);
  const Stage fine = set_stage(palpation("rectal-palpation-fine.toml"), kAspect);
  // The same organs: what differs is where their nodes lie, by some tenths of a millimetre at the outline.
  EXPECT_LT((coarse.camera.eye - fine.camera.eye).norm(), 0.05 * coarse.camera.eye.norm());
  EXPECT_GT(coarse.probes.front().shaft.dot(fine.probes.front().shaft), 0.99);
}

TEST(SetStage, LooksFromWhereItIsTold) {
  const Model model = rectal_palpation();
  const double quarter = M_PI / 2;
  struct {
    ViewPoint from;
    Vec3 back, up;
  } const cases[] = {{{0, 0}, -Vec3::UnitY(), Vec3::UnitZ()},           // front
                     {{quarter, 0}, Vec3::UnitX(), Vec3::UnitZ()},      // right
                     {{2 * quarter, 0}, Vec3::UnitY(), Vec3::UnitZ()},  // back
                     {{-quarter, 0}, -Vec3::UnitX(), Vec3::UnitZ()},    // left
                     {{0, quarter}, Vec3::UnitZ(), Vec3::UnitY()},      // top
                     {{0, -quarter}, -Vec3::UnitZ(), -Vec3::UnitY()}};
  for (const auto& [from, back, up] : cases) {
    const Camera camera = set_stage(model, kAspect, from).camera;
    EXPECT_LT(((camera.eye - camera.target).normalized() - back).norm(), 1e-9);
    EXPECT_LT((camera.up - up).norm(), 1e-9);
  }
}

TEST(SetStage, ScaleBarIsARoundLength) {
  const double bar = set_stage(rectal_palpation(), kAspect).scale_bar;
  EXPECT_NEAR(bar, 0.010, 1e-12);  // the organs are 3 to 8 cm long
}

}  // namespace
}  // namespace palpate::sim
