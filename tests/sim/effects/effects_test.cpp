#include "sim/effects/effects.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <stdexcept>
#include <string>
#include <vector>

#include "tests/sim/support/two_boxes.hpp"

namespace palpate::sim {
namespace {

using test::compile_scene;
using test::write_two_boxes;

EffectState contact_of(std::vector<Override> overrides) {
  return effects().front()->state(load_scene(write_two_boxes(), overrides));
}

TEST(Effects, AreListedInTheOrderOfTheirSlotsWithNamesOfTheirOwn) {
  std::vector<std::string_view> names;
  for (const Effect* effect : effects()) names.push_back(effect->name);
  EXPECT_THAT(names, testing::ElementsAre("contact", "friction", "viscosity", "near-incompressibility",
                                          "large deformation"));
}

TEST(Effects, SayWhyContactIsOnOrOff) {
  EXPECT_TRUE(contact_of({}).on);
  EXPECT_EQ(contact_of({}).reason, "contact.model = \"kuroda\" between upper and lower");
  EXPECT_EQ(contact_of({}).key, "contact.model");
  EXPECT_EQ(contact_of({{"contact.model", "none"}}).reason, "contact.model = \"none\"");
  EXPECT_EQ(contact_of({{"contact.touch", "[]"}}).reason, "no pair of bodies in contact.touch");
  const EffectState absent = contact_of({{"bodies.lower.present", "false"}});
  EXPECT_FALSE(absent.on);
  EXPECT_EQ(absent.reason, "of each pair in contact.touch one body is not present");
}

TEST(Effects, ThatAreOnCanBeTakenOutOfAModel) {
  const Model model = compile_scene(write_two_boxes());
  EXPECT_FALSE(model.pairs.empty());
  EXPECT_TRUE(effects().front()->without(model).pairs.empty());
}

TEST(Effects, OfLaterVersionsAreRefusedByTheirKeys) {
  int refused = 0;
  for (const EffectKey& later : effect_keys()) {
    if (later.read) continue;
    ++refused;
    const std::string table = later.table == "bodies" ? "bodies.upper" : std::string(later.table);
    const std::vector<Override> calling{{table + "." + std::string(later.key.name), "1"}};
    EXPECT_THAT([&] { load_scene(write_two_boxes(), calling); },
                testing::ThrowsMessage<std::invalid_argument>(testing::HasSubstr(
                    fmt::format("{}.{}: calls for {}, which this version does not simulate", table,
                                later.key.name, later.calls_for))));
  }
  EXPECT_EQ(refused, 2);
}

}  // namespace
}  // namespace palpate::sim
