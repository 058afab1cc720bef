#include "sim/cost/variant_result.hpp"

#include <gmock/gmock.h>

#include <string>

namespace palpate::sim {
namespace {

Scene scene() {
  Scene scene{.name = "a scene", .bodies = {{.name = "organ", .refinements = {"finer.msh", "finest.msh"}}}};
  scene.probes.push_back({.name = "finger", .body = "organ", .kind = "pad"});
  return scene;
}

/// A result whose force is so much of 1 N, at a time [us].
VariantResult result(const Variant& variant, double force, double time) {
  return {.variant = variant, .forces = {force, force}, .rounds = {time}, .time = {time, time, time, time}};
}

const Variant kExactCoarse{.model = "exact"}, kExactFine{.model = "exact", .mesh = 1},
    kKurodaCoarse{.model = "kuroda"}, kEarlyCoarse{.model = "exact", .tolerance = 0.05};

std::vector<VariantResult> results() {
  return {result(kExactCoarse, 1.2, 4), result(kExactFine, 1.03, 900), result(kKurodaCoarse, 1.1, 8),
          result(kEarlyCoarse, 1.21, 3)};
}

constexpr double kReference[] = {1.0, 1.0};

TEST(ErrorsOf, TellTheMeshFromTheModelFromTheSolver) {
  const auto errors = errors_of(scene(), results(), kReference);
  EXPECT_NEAR(errors[0].whole, 0.2, 1e-12);
  EXPECT_NEAR(*errors[0].discretisation, 0.2, 1e-12);
  EXPECT_EQ(errors[0].contact_model, 0.0);
  EXPECT_EQ(errors[0].solver, 0.0);
  EXPECT_NEAR(errors[2].whole, 0.1, 1e-12);  // two errors may cancel
  EXPECT_NEAR(*errors[2].discretisation, 0.2, 1e-12);
  EXPECT_NEAR(errors[2].contact_model, 0.1, 1e-12);
  EXPECT_NEAR(errors[3].solver, 0.01, 1e-12);
  EXPECT_EQ(errors[3].contact_model, 0.0);
}

TEST(ErrorsOf, MarkTheFront) {
  const auto errors = errors_of(scene(), results(), kReference);
  EXPECT_TRUE(errors[0].on_front);  // faster than what is more accurate
  EXPECT_TRUE(errors[1].on_front);  // the most accurate
  EXPECT_TRUE(errors[2].on_front);
  EXPECT_TRUE(errors[3].on_front);  // the fastest
  auto more = results();
  more.push_back(result({.model = "sibille"}, 1.3, 5));
  EXPECT_FALSE(errors_of(scene(), more, kReference).back().on_front);
}

TEST(ErrorsOf, APointHasNoErrorOfTheMesh) {
  Scene pointed = scene();
  pointed.probes[0].kind = "point";
  const auto errors = errors_of(pointed, std::vector{results()[0], results()[2]}, kReference);
  EXPECT_FALSE(errors[1].discretisation.has_value());
}

ExtrapolatedCurve reference(double uncertainty) {
  return {.converges = true, .forces = {1, 1}, .uncertainty = uncertainty};
}

Advice advice(double uncertainty, double period = 1e3) {
  const auto all = results();
  return advise(all, errors_of(scene(), all, kReference), reference(uncertainty),
                {.lower = 0.15, .upper = 0.2}, period);
}

TEST(Advise, TakesTheCheapestThatIsNotFeltAndTheMostAccurateInTime) {
  EXPECT_EQ(advice(0.01).cheapest_unfelt, 2U);  // kuroda, 10 %
  EXPECT_EQ(advice(0.01).most_accurate_in_time, 1U);
  EXPECT_EQ(advice(0.01, 100).most_accurate_in_time, 2U);  // the finer mesh does not keep that rate
  EXPECT_EQ(advice(0.06).cheapest_unfelt, 1U);             // what is not known might be felt
  EXPECT_EQ(advice(0.01, 1).most_accurate_in_time, std::nullopt);
}

TEST(Advise, RefusesAReferenceThatIsNotKnown) {
  EXPECT_THAT(advice(0.15).refused, testing::HasSubstr("a finger tells"));
  const auto all = results();
  const auto errors = errors_of(scene(), all, kReference);
  const Band wide{.lower = 0.9, .upper = 1.0};
  EXPECT_THAT(advise(all, errors, reference(0.3), wide, 1e3).refused,
              testing::HasSubstr("no variant differs"));
  EXPECT_EQ(advise(all, errors, {.how = "it does not converge"}, wide, 1e3).refused, "it does not converge");
}

TEST(VariantsOf, AreOfEveryMeshWhereThereIsALimit) {
  const auto all = variants_of(scene());
  const auto count = [&](const auto& is) { return std::ranges::count_if(all, is); };
  EXPECT_EQ(count([](const Variant& v) { return v == Variant{.model = "kuroda", .mesh = v.mesh}; }), 3);
  EXPECT_EQ(count([](const Variant& v) { return v.precision == Precision::Single; }), 3);
  EXPECT_EQ(count([](const Variant& v) { return v.interior == 2; }), 1);
  Scene pointed = scene();
  pointed.probes[0].kind = "point";
  for (const Variant& variant : variants_of(pointed)) EXPECT_TRUE(variant.mesh == 0 && variant.interior == 0);
  Scene rough = scene();
  rough.contact.effects["friction"] = {0.3};
  EXPECT_THAT(variants_of(rough), testing::Contains(exact_on(rough, 0)));
  EXPECT_TRUE(exact_on(rough, 0).friction);
}

TEST(MeshesOf, RefusesFamiliesOfUnequalSize) {
  Scene uneven = scene();
  uneven.bodies.push_back({.name = "other", .refinements = {"one.msh"}});
  EXPECT_EQ(meshes_of(scene()), 3);
  try {
    meshes_of(uneven);
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("bodies.other.refinements"));
  }
}

}  // namespace
}  // namespace palpate::sim
