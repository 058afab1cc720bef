#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>
#include <stdexcept>

#include "sim/scene/scene.hpp"
#include "tests/sim/support/two_boxes.hpp"

namespace palpate::sim {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

/// The scene of two boxes with one piece of its text replaced.
std::filesystem::path scene_with(const std::string& old_text, const std::string& new_text) {
  const auto file = test::write_two_boxes();
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  std::string changed = text.str();
  const auto at = changed.find(old_text);
  EXPECT_NE(at, std::string::npos) << old_text;
  changed.replace(at, old_text.size(), new_text);
  std::ofstream(file) << changed;
  return file;
}

TEST(LoadScene, ReadsBodiesContactAndProbeInSi) {
  const Scene scene = load_scene(test::write_two_boxes());
  ASSERT_EQ(scene.bodies.size(), 2u);
  EXPECT_EQ(scene.bodies[0].name, "upper");
  EXPECT_DOUBLE_EQ(scene.bodies[1].material.young_modulus, 1e6);
  EXPECT_DOUBLE_EQ(scene.bodies[0].material.poisson_ratio, 0.40);
  EXPECT_EQ(scene.contact.model, "kuroda");
  EXPECT_DOUBLE_EQ(scene.probes[0].depth, 2e-3);
  EXPECT_EQ(scene.probes[0].direction, Vec3(0, 0, -1));
}

TEST(LoadScene, PutsReplacementsInPlaceOfWhatTheFileSays) {
  const Scene scene =
      load_scene(test::write_two_boxes(), std::vector<Override>{{"bodies.lower.young_modulus", "5.0 MPa"},
                                                                {"bodies.lower.present", "false"},
                                                                {"contact.model", "\"sibille\""}});
  EXPECT_DOUBLE_EQ(scene.bodies[1].material.young_modulus, 5e6);
  EXPECT_FALSE(scene.bodies[1].present);
  EXPECT_EQ(scene.contact.model, "sibille");
}

struct Refusal {
  std::string name, old_text, new_text, message;
};
class RefusedScene : public ::testing::TestWithParam<Refusal> {};

TEST_P(RefusedScene, SaysWhereWhatAndWhatIsAccepted) {
  const Refusal& refusal = GetParam();
  const auto file = scene_with(refusal.old_text, refusal.new_text);
  EXPECT_THAT([&] { load_scene(file); }, ThrowsMessage<std::invalid_argument>(
                                             AllOf(HasSubstr("scene.toml"), HasSubstr(refusal.message))));
}

INSTANTIATE_TEST_SUITE_P(
    Bad, RefusedScene,
    ::testing::Values(
        Refusal{
            "UnknownKey", "touchable = \"z_min\"", "touchabel = \"z_min\"",
            "scene.toml:8: bodies.upper.touchabel: unknown key, perhaps touchable is meant; accepted here:"},
        Refusal{"NoUnit", "\"1 MPa\"", "\"1\"",
                "scene.toml:5: bodies.upper.young_modulus: \"1\" has no unit"},
        Refusal{"NumberForQuantity", "\"1 MPa\"", "1.0", "accepted: a quantity with its unit"},
        Refusal{
            "PoissonOneHalf", "0.40", "0.5",
            "scene.toml:6: bodies.upper.poisson_ratio: found 0.5, accepted: a number greater than -1 and less than 0.5"},
        Refusal{"PoissonBelow", "0.40", "-1.0", "bodies.upper.poisson_ratio: found -1"},
        Refusal{"PoissonNaN", "0.40", "nan", "bodies.upper.poisson_ratio: found nan"},
        Refusal{"NegativeModulus", "\"1 MPa\"", "\"-1 MPa\"",
                "scene.toml:5: bodies.upper.young_modulus: found \"-1 MPa\", accepted: a quantity > 0"},
        Refusal{"UnknownBody", "[[\"upper\", \"lower\"]]", "[[\"upper\", \"liver\"]]",
                "\"liver\" is no body"},
        Refusal{"TouchesItself", "[[\"upper\", \"lower\"]]", "[[\"upper\", \"upper\"]]", "touches itself"},
        Refusal{"UnknownModel", "\"kuroda\"", "\"penalty\"", "accepted: none, sibille, kuroda"},
        Refusal{"PairingOfAnotherModel", "model = \"kuroda\"", "model = \"kuroda\"\npairing = \"both\"",
                "contact.pairing: is for the contact model exact"},
        Refusal{"PairingOfNobody", "model = \"kuroda\"", "model = \"exact\"\npairing = \"nodes of liver\"",
                "accepted: \"both\", \"nodes of upper\", \"nodes of lower\""},
        Refusal{"ReadingOfAnotherModel", "model = \"kuroda\"", "model = \"sibille\"\nreading = \"literal\"",
                "contact.reading: is for the contact model kuroda"},
        Refusal{"PrecisionOfAnotherModel", "model = \"kuroda\"", "model = \"kuroda\"\nprecision = \"single\"",
                "contact.precision: is for the contact model exact"},
        Refusal{"UnknownPrecision", "model = \"kuroda\"", "model = \"exact\"\nprecision = \"half\"",
                "contact.precision: found \"half\", accepted: double, single"},
        Refusal{"TooManyCutsInside", "poisson_ratio = 0.40", "poisson_ratio = 0.40\ninterior = 4",
                "bodies.upper.interior: found 4, accepted: a whole number from 0 to 3"},
        Refusal{"RefinementsThatAreNoFiles", "poisson_ratio = 0.40",
                "poisson_ratio = 0.40\nrefinements = [1]", "bodies.upper.refinements: holds"},
        Refusal{"UnknownReading", "model = \"kuroda\"", "model = \"kuroda\"\nreading = \"strict\"",
                "contact.reading: found \"strict\", accepted: every pair, literal"},
        Refusal{"NegativeOverlap", "model = \"kuroda\"", "model = \"kuroda\"\noverlap = \"-0.1 mm\"",
                "contact.overlap: found \"-0.1 mm\", accepted: a quantity >= 0"},
        Refusal{"OverlapWithoutUnit", "model = \"kuroda\"", "model = \"kuroda\"\noverlap = \"0.1\"",
                "contact.overlap: \"0.1\" has no unit"},
        Refusal{"NegativeFriction", "model = \"kuroda\"", "model = \"exact\"\nfriction = -0.3",
                "contact.friction: found -0.3, accepted: a number >= 0"},
        Refusal{"LaterEffect", "young_modulus", "relaxation = [[0.3, \"0.5 s\"]]\nyoung_modulus",
                "calls for viscosity"},
        Refusal{"NoDirection", "[0, 0, -1]", "[0, 0, 0]", "has no length"},
        Refusal{"PointWithRadius", "kind = \"point\"", "kind = \"point\"\nradius = \"3 mm\"",
                "a point has no radius"},
        Refusal{"PadWithoutRadius", "kind = \"point\"", "kind = \"pad\"", "a pad needs a radius"},
        Refusal{"BrokenToml", "[contact]", "[contact", "no valid TOML"}),
    [](const auto& refusal) { return refusal.param.name; });

TEST(LoadScene, NamesAMissingFile) {
  EXPECT_THAT([] { load_scene("no/such/scene.toml"); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("no/such/scene.toml: no such file")));
}

// A mesh is looked for when the scene is compiled; the message leads back to the line that names it.
TEST(Compile, AMeshThatIsMissingOrNoneIsToldWithTheLineThatNamesIt) {
  const auto missing = scene_with("mesh = \"lower.msh\"", "mesh = \"lowest.msh\"");
  EXPECT_THAT([&] { test::compile_scene(missing); },
              ThrowsMessage<std::invalid_argument>(AllOf(HasSubstr("scene.toml:11: bodies.lower.mesh: "),
                                                         HasSubstr("lowest.msh: no such file"))));
  const auto damaged = test::write_two_boxes();
  std::ofstream(damaged.parent_path() / "lower.msh") << "no mesh";
  EXPECT_THAT([&] { test::compile_scene(damaged); },
              ThrowsMessage<std::invalid_argument>(
                  AllOf(HasSubstr("scene.toml:11: bodies.lower.mesh: "), HasSubstr("lower.msh"))));
  // Asked for by an override: no line of the file says so.
  EXPECT_THAT(
      [] {
        test::compile_scene(test::write_two_boxes(), std::vector<Override>{{"bodies.lower.mesh", "x.msh"}});
      },
      ThrowsMessage<std::invalid_argument>(HasSubstr("scene.toml: bodies.lower.mesh: ")));
}

TEST(Compile, WhatTheMeshDoesNotHaveIsToldWithItsLine) {
  EXPECT_THAT([] { test::compile_scene(scene_with("fixed = \"sides\"", "fixed = \"sacrum\"")); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("scene.toml:7: bodies.upper.fixed: ")));
}

TEST(LoadScene, TheLineOfAKeyIsNoPartOfTheScene) {
  const Scene scene = load_scene(test::write_two_boxes());
  Scene moved = scene;
  for (auto& [key, line] : moved.lines.of_key) ++line;
  EXPECT_EQ(moved, scene);
}

TEST(Compile, NamesTheGroupsThatAMeshHas) {
  const auto file = scene_with("fixed = \"sides\"", "fixed = \"sacrum\"");
  EXPECT_THAT([&] { test::compile_scene(file); },
              ThrowsMessage<std::invalid_argument>(AllOf(
                  HasSubstr("bodies.upper.fixed"), HasSubstr("no group \"sacrum\""), HasSubstr("z_min"))));
}

TEST(Compile, RefusesBodiesThatOverlapAtRest) {
  const auto file = test::write_two_boxes({.gap = -1e-3, .shift = 1.7e-3});
  EXPECT_THAT([&] { test::compile_scene(file); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("upper and lower overlap at rest by 1 mm")));
}

TEST(Compile, RefusesAProbeOnASupport) {
  const auto file = scene_with("kind = \"point\"\nat = [\"0.015 m\", \"0.015 m\"",
                               "kind = \"point\"\nat = [\"0 m\", \"0 m\"");
  EXPECT_THAT([&] { test::compile_scene(file); },
              ThrowsMessage<std::invalid_argument>(AllOf(HasSubstr("probes.finger"), HasSubstr("is fixed"))));
}

}  // namespace
}  // namespace palpate::sim
