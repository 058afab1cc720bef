#include "sim/compile/combinations.hpp"

#include <gmock/gmock.h>

#include <array>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "sim/contact/laws.hpp"
#include "sim/effects/effects.hpp"
#include "sim/probe/kinds.hpp"
#include "sim/scene/accepted.hpp"
#include "sim/scene/refuse_key.hpp"
#include "tests/sim/support/two_boxes.hpp"

namespace palpate::sim {
namespace {

using testing::Contains;
using testing::HasSubstr;

EffectState slipping(const Scene& scene) {
  if (scene.name == "still") return {false, "no contact.slip"};
  return {true, "contact.slip = 0.3", "contact.slip"};
}
EffectState sticking(const Scene&) {
  return {true, "contact.glue = 2", "contact.glue"};
}

constexpr std::array kOfSlip{Exclusion{Choice::ContactModel, "kuroda", "nothing balances"}};
constexpr std::array kOfGlue{Exclusion{Choice::Effect, "slip", "what is glued does not slip"}};
constexpr std::array kOfPoint{Exclusion{Choice::ContactModel, "kuroda", "it is too small"},
                              Exclusion{Choice::ContactModel, "none", "it is too large"}};

constexpr Effect kSlip{.name = "slip", .excludes = kOfSlip, .state = slipping};
constexpr Effect kFreeSlip{.name = "slip", .state = slipping};
constexpr Effect kGlue{.name = "glue", .excludes = kOfGlue, .state = sticking};
constexpr ProbeKind kPickyPoint{.keys = {.name = "point"}, .excludes = kOfPoint};
constexpr ProbeKind kAnyPoint{.keys = {.name = "point"}};
constexpr ProbeKind kAnyPad{.keys = {.name = "pad"}};

/// A scene with probes.finger.kind = "point" and this contact model.
Scene scene_with(std::string_view model) {
  return load_scene(test::write_two_boxes(), std::vector<Override>{{"contact.model", std::string(model)}});
}

/// "KEY: WHAT" that is refused; empty where nothing is.
std::string refusal(const Scene& scene, std::vector<const Effect*> effects,
                    std::vector<const ProbeKind*> kinds) {
  try {
    refuse_combinations(scene, effects, kinds);
  } catch (const RefusedKey& refused) {
    return refused.what();
  }
  return "";
}

TEST(Combinations, OfAnEffectAndAContactModelAreRefusedWithKeyValueAndWhatIsAccepted) {
  EXPECT_EQ(
      refusal(scene_with("kuroda"), {&kSlip}, {&kAnyPoint}),
      "contact.slip: slip (contact.slip = 0.3) cannot be combined with contact.model = \"kuroda\": nothing "
      "balances; accepted: contact.model = \"none\" or \"sibille\" or \"exact\", or the scene without "
      "contact.slip");
  EXPECT_EQ(refusal(scene_with("exact"), {&kSlip}, {&kAnyPoint}), "");
  Scene still = scene_with("kuroda");
  still.name = "still";
  EXPECT_EQ(refusal(still, {&kSlip}, {&kAnyPoint}), "");
}

TEST(Combinations, OfAProbeKindAndAContactModelNameTheProbe) {
  EXPECT_EQ(refusal(scene_with("kuroda"), {}, {&kPickyPoint, &kAnyPad}),
            "probes.finger.kind: probes.finger.kind = \"point\" cannot be combined with contact.model = "
            "\"kuroda\": it is too small; accepted: contact.model = \"sibille\" or \"exact\", or "
            "probes.finger.kind = \"pad\"");
  EXPECT_THAT(refusal(scene_with("none"), {}, {&kPickyPoint, &kAnyPad}), HasSubstr("it is too large"));
  EXPECT_EQ(refusal(scene_with("sibille"), {}, {&kPickyPoint, &kAnyPad}), "");
}

TEST(Combinations, OfTwoEffectsAreStatedByEither) {
  for (const std::vector<const Effect*>& order : {std::vector{&kGlue, &kFreeSlip}, {&kFreeSlip, &kGlue}})
    EXPECT_EQ(
        refusal(scene_with("kuroda"), order, {&kAnyPoint}),
        "contact.glue: glue (contact.glue = 2) cannot be combined with slip (contact.slip = 0.3): what is "
        "glued does not slip; accepted: the scene without contact.slip, or the scene without contact.glue");
}

TEST(Combinations, AreOfThingsThatThereAreEachWithItsReason) {
  std::array<std::set<std::string_view>, 3> known;
  for (const Effect* effect : effects()) known[0].insert(effect->name);
  for (const ContactLaw* law : contact_laws()) known[1].insert(law->name);
  for (const ProbeKind* kind : probe_kinds()) known[2].insert(kind->keys.name);
  const std::vector<Combination> table = unsupported_combinations(effects(), probe_kinds());
  for (const Combination& row : table) {
    EXPECT_THAT(known[static_cast<std::size_t>(row.other.choice)], Contains(row.other.name));
    EXPECT_FALSE(row.other.why.empty()) << row.name;
  }
  EXPECT_EQ(combinations_in_words().size(), table.size());
  EXPECT_THAT(combinations_in_words(), Contains(HasSubstr("friction and the contact model `kuroda`: ")));
}

TEST(Combinations, LeaveAPointEveryContactModel) {
  for (const ContactLaw* law : contact_laws())
    EXPECT_EQ(refusal(scene_with(law->name), {effects().begin(), effects().end()},
                      {probe_kinds().begin(), probe_kinds().end()}),
              "");
}

}  // namespace
}  // namespace palpate::sim
