#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/trials/support/protocols.hpp"
#include "trials/protocol/protocol.hpp"

using namespace palpate::trials;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

namespace {

std::string with_factors(const std::string& factors) {
  const std::string text = test::with(test::shipped_text(), "between_models = \"sign-flip\"", "");
  return test::with(text, "\"contact.model\" = [\"kuroda\", \"sibille\"]", factors);
}

std::vector<std::string> cells_of(const Protocol& protocol) {
  std::vector<std::string> names;
  for (const Cell& cell : protocol.cells) names.push_back(cell.name);
  return names;
}

std::string refusal_of(const std::string& text) {
  return test::message_of<std::invalid_argument>([&] { parse_protocol(text, "p.toml"); });
}

std::string refusal_of_factors(const std::string& factors) {
  return refusal_of(with_factors(factors));
}

}  // namespace

TEST(FactorLevels, HaveNamesForValuesOfASceneKey) {
  const Protocol protocol = parse_protocol(
      with_factors("\"bodies.prostate.offset\" = { near = [\"0 mm\", \"0 mm\", \"0 mm\"], \"0.6 mm away\" = "
                   "[\"0 mm\", \"0 mm\", \"0.6 mm\"] }\n\"contact.model\" = [\"kuroda\", \"sibille\"]"),
      "p.toml");
  EXPECT_THAT(cells_of(protocol),
              ElementsAre("near, kuroda", "near, sibille", "0.6 mm away, kuroda", "0.6 mm away, sibille"));
  const Stimulus& far = protocol.stimuli[stimulus_index(protocol, 2, 0)];
  EXPECT_EQ(far.overrides[0].key, "bodies.prostate.offset");
  EXPECT_THAT(far.overrides[0].value, HasSubstr("0.6 mm"));
}

TEST(FactorLevels, OfAFactorWithANameAreTablesOfSceneKeys) {
  const Protocol protocol = parse_protocol(
      with_factors("gap = { near = {}, far = { \"bodies.prostate.offset\" = [\"0 mm\", \"0 mm\", \"1 mm\"], "
                   "\"probes.finger.depth\" = \"6 mm\" } }"),
      "p.toml");
  EXPECT_THAT(cells_of(protocol), ElementsAre("near", "far"));
  EXPECT_EQ(protocol.factors[0].name, "gap");
  EXPECT_TRUE(protocol.factors[0].levels[0].overrides.empty());
  EXPECT_EQ(protocol.factors[0].levels[1].overrides.size(), 2u);
}

TEST(FactorLevels, MayBeOne) {
  const Protocol protocol = parse_protocol(with_factors("\"contact.model\" = [\"kuroda\"]"), "p.toml");
  EXPECT_THAT(cells_of(protocol), ElementsAre("kuroda"));
}

TEST(FactorLevels, ThatSayNothingAreRefused) {
  EXPECT_THAT(refusal_of_factors("\"contact.model\" = []"), HasSubstr("has no level"));
  EXPECT_THAT(refusal_of_factors("gap = { near = [\"0 mm\"], far = [\"1 mm\"] }"),
              AllOf(HasSubstr("p.toml:15: factors.gap.near: \"gap\" is no key of a scene"),
                    HasSubstr("\"bodies.prostate.offset\" = { near = [..], .. }")));
  EXPECT_THAT(refusal_of_factors("\"contact.model\" = \"kuroda\""),
              HasSubstr("accepted: the levels, such as"));
  EXPECT_THAT(refusal_of_factors("\"contact.model\" = { \"\" = \"kuroda\" }"),
              HasSubstr("a level's name is empty"));
  EXPECT_THAT(refusal_of_factors("\"contact.model\" = [\"kuroda\", \"kuroda\"]"), HasSubstr("twice"));
}

TEST(FactorLevels, AreComparedWhereTheyAreTwoOrTwoByTwo) {
  const std::string planned = "between_models = \"sign-flip\"";
  const auto with_comparison = [&](const std::string& factors) {
    return test::with(with_factors(factors), "alpha          = 0.05", "alpha = 0.05\n" + planned);
  };
  const std::string models = "\"contact.model\" = [\"kuroda\", \"sibille\"]";
  const std::string depths = "\n\"probes.finger.depth\" = [\"4 mm\", \"5 mm\"]";
  EXPECT_NO_THROW(parse_protocol(with_comparison(models + depths), "p.toml"));
  EXPECT_NO_THROW(
      parse_protocol(with_comparison(models + "\n\"probes.finger.depth\" = [\"4 mm\"]"), "p.toml"));
  try {
    parse_protocol(with_comparison(models + "\n\"probes.finger.depth\" = [\"4 mm\", \"5 mm\", \"6 mm\"]"),
                   "p.toml");
    ADD_FAILURE();
  } catch (const std::invalid_argument& error) {
    EXPECT_THAT(error.what(), HasSubstr("have 2 x 3 levels"));
  }
}

TEST(Adjust, IsOneOfThreeAndNotWithLooks) {
  const auto with_key = [](const std::string& key) {
    return test::with(test::shipped_text(), "alpha          = 0.05", "alpha = 0.05\n" + key);
  };
  EXPECT_EQ(parse_protocol(test::shipped_text(), "p.toml").analysis.adjust, Adjust::None);
  EXPECT_EQ(parse_protocol(with_key("adjust = \"holm\""), "p.toml").analysis.adjust, Adjust::Holm);
  for (const auto& [key, message] :
       {std::pair{"adjust = \"bonferroni\"", "accepted: none, holm, hochberg, benjamini-hochberg"},
        std::pair{"adjust = \"holm\"\nlooks = [15]\nspending = \"pocock\"", "accepted without adjust"}})
    EXPECT_THAT(refusal_of(with_key(key)), HasSubstr(message));
}
