#include "tests/bench/rows.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "sim/contact/laws.hpp"
#include "sim/effects/effects.hpp"
#include "sim/probe/kinds.hpp"
#include "tests/support/places.hpp"

namespace palpate::bench {
namespace {

sim::Scene scene_of(const Row& row) {
  return sim::load_scene(fmt::format("{}/data/scenes/{}.toml", test::source_folder(), row.scene), row.calls);
}

bool any_row(bool (*holds)(const sim::Scene& scene, std::string_view name), std::string_view name) {
  return std::ranges::any_of(rows(), [&](const Row& row) { return holds(scene_of(row), name); });
}

// What somebody adds to one of the lists is timed, or this fails.
TEST(BenchRows, EveryLawEffectAndKindOfProbeIsTimed) {
  for (const sim::ContactLaw* law : sim::contact_laws())
    EXPECT_TRUE(
        any_row([](const sim::Scene& scene, auto name) { return scene.contact.model == name; }, law->name))
        << law->name;
  for (const sim::ProbeKind* kind : sim::probe_kinds()) {
    const std::string_view name = kind->keys.name;
    EXPECT_TRUE(
        any_row([](const sim::Scene& scene, auto of) { return scene.probes.front().kind == of; }, name))
        << name;
    if (kind->keys.takes_reach)
      EXPECT_TRUE(
          any_row([](const sim::Scene& scene,
                     auto of) { return scene.probes.front().kind == of && scene.probes.front().reach > 0.0; },
                  name))
          << name << " with a reach";
  }
  for (const sim::EffectKey& effect : sim::effect_keys()) {
    if (!effect.read) continue;  // of a later version
    EXPECT_TRUE(any_row(
        [](const sim::Scene& scene, auto name) {
          return scene.contact.effects.contains(std::string(name)) ||
                 std::ranges::any_of(scene.bodies, [&](const sim::BodySpec& body) {
                   return body.effects.contains(std::string(name));
                 });
        },
        effect.key.name))
        << effect.key.name;
  }
  EXPECT_TRUE(any_row([](const sim::Scene& scene, auto) { return scene.contact.tolerance > 0.0; }, ""));
}

// So that a ratio tells of what the row calls for and of nothing else.
TEST(BenchRows, ACounterpartIsAnEarlierRowOnTheSameScene) {
  std::vector<Row> earlier;
  for (const Row& row : rows()) {
    EXPECT_FALSE(std::ranges::any_of(earlier, [&](const Row& other) { return other.name == row.name; }))
        << row.name;
    if (!row.plain.empty()) {
      const auto plain = std::ranges::find(earlier, row.plain, &Row::name);
      ASSERT_NE(plain, earlier.end()) << row.name;
      EXPECT_EQ(plain->scene, row.scene) << row.name;
    }
    earlier.push_back(row);
  }
}

// They are cells of CSV as they stand.
TEST(BenchRows, NamesNeedNoQuotes) {
  std::vector<Row> all = rows();
  for (const Family& family : families()) all.insert(all.end(), family.sizes.begin(), family.sizes.end());
  for (const Row& row : all) EXPECT_EQ(row.name.find_first_of(",\"\n"), std::string::npos) << row.name;
}

TEST(BenchRows, AFamilyIsOnePressOnFinerAndFinerMeshes) {
  for (const Family& family : families()) {
    ASSERT_GE(family.sizes.size(), 3u);
    std::uintmax_t bytes = 0;
    for (const Row& size : family.sizes) {
      const sim::Scene scene = scene_of(size);
      EXPECT_EQ(scene.contact.model, family.law);
      std::uintmax_t meshes = 0;
      for (const sim::BodySpec& body : scene.bodies) meshes += std::filesystem::file_size(body.mesh);
      EXPECT_GT(meshes, bytes) << size.name;
      bytes = meshes;
    }
  }
}

}  // namespace
}  // namespace palpate::bench
