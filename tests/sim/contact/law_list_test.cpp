#include <gmock/gmock.h>

#include <set>
#include <stdexcept>
#include <string>
#include <tuple>

#include "sim/contact/laws.hpp"
#include "sim/cycle/press.hpp"
#include "sim/scene/accepted.hpp"
#include "tests/sim/support/two_boxes.hpp"

namespace palpate::sim {
namespace {

using test::compile_scene;
using test::write_two_boxes;

TEST(ContactLaws, HaveNamesOfTheirOwnThatASceneAccepts) {
  std::set<std::string_view> names;
  for (const ContactLaw* law : contact_laws()) {
    EXPECT_TRUE(names.insert(law->name).second) << law->name;
    EXPECT_EQ(&contact_law(law->name), law);
  }
  const base::Words words = contact_model_words();
  ASSERT_EQ(words.now.size(), names.size());
  for (const base::Word& known : words.now) {
    EXPECT_TRUE(names.contains(known.word)) << known.word;
    EXPECT_FALSE(known.meaning.empty()) << known.word;  // for the reference
  }
  for (const std::string_view later : words.later) EXPECT_FALSE(names.contains(later));
  EXPECT_TRUE(names.contains(kNoContact));
  EXPECT_THAT([] { contact_law("other"); }, testing::ThrowsMessage<std::invalid_argument>(testing::HasSubstr(
                                                "found \"other\", accepted: none, sibille, kuroda, exact")));
  EXPECT_EQ(choice_of_contact_models(), "none, sibille, kuroda or exact");
}

/// What every law owes the simulation, whatever it does inside.
class EveryLaw : public testing::TestWithParam<const ContactLaw*> {
 protected:
  EveryLaw() : model_(compile_scene(write_two_boxes({.shift = 1.7e-3}))) { model_.law = GetParam(); }
  Model model_;
};

TEST_P(EveryLaw, PreparesNothingWhereNoBodiesTouch) {
  EXPECT_EQ(GetParam()->prepare(without_contact(model_)), nullptr);
}

TEST_P(EveryLaw, CarriesNoHistory) {
  EXPECT_EQ(GetParam()->memory_size(model_), 0U);
}

TEST_P(EveryLaw, GivesTheSameForceTwiceAndTheSameBitsAfterAReset) {
  Simulation simulation(model_);
  const auto deep = displaced_by(model_, 1.5e-3), shallow = displaced_by(model_, 0.7e-3);
  const auto solved = [&] {
    const CycleResult result = simulation.step(deep, kCyclePeriod);
    EXPECT_EQ(result.solve.stop, Stop::Converged);
    return std::tuple(Vec3(result.probe_forces[0]), simulation.loads().on_body, simulation.displacement(1));
  };
  const auto first = solved();
  const auto again = [&] {  // a warm start may move a force by the solver's tolerance
    const Vec3 here = std::get<0>(solved()), there = std::get<0>(first);
    EXPECT_LE((here - there).norm(), 1e-10 * there.norm());
  };
  again();
  simulation.step(shallow, kCyclePeriod);
  again();
  simulation.reset();
  EXPECT_TRUE(simulation.loads().on_body[0].isZero(0.0));
  EXPECT_EQ(solved(), first);
}

INSTANTIATE_TEST_SUITE_P(Laws, EveryLaw, testing::ValuesIn(contact_laws().begin(), contact_laws().end()),
                         [](const auto& law) { return std::string(law.param->name); });

}  // namespace
}  // namespace palpate::sim
