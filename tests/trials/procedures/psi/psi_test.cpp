#include "trials/procedures/psi/psi.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/trials/support/adaptive.hpp"
#include "trials/adaptive/entropy_choice.hpp"
#include "trials/plan/random.hpp"

namespace palpate::trials::test {
namespace {

using testing::HasSubstr;

double phi(double z) {
  return 0.5 * std::erfc(-z / std::numbers::sqrt2);
}

const std::string kTwoIntervalPsi =
    "kind = \"psi\"\nlevels = [0.25, 0.5, 0.75, 1, 1.25, 1.5, 2, 2.5, 3, 4]\n"
    "alpha = [0.5, 0.75, 1, 1.25, 1.5, 2]\nbeta = [0.5, 1, 1.5, 2, 3]\nlapse = 0.04\n";

}  // namespace

TEST(Psi, TwoIntervalsAreAnsweredByTheirDistance) {
  const LoadedProcedure loaded =
      procedure_of("kind = \"psi\"\nlevels = [0, 1, 3]\nalpha = [1, 2]\nbeta = 2\nlapse = 0.1");
  const auto& share = static_cast<const EntropyDesign&>(*loaded.design).share_correct;  // level-major
  EXPECT_NEAR(share[0], 0.5, 1e-12);  // no difference to feel
  EXPECT_NEAR(share[2], 0.05 + 0.9 * phi(1 / std::numbers::sqrt2), 1e-12);
  EXPECT_NEAR(share[5], 0.05 + 0.9 * phi(2.25 / std::numbers::sqrt2), 1e-12);
}

// yes/no with one spread is QUEST+ with a normal function whose guess and lapse rates are half the lapses
// each.
TEST(Psi, YesNoIsQuestPlusWithANormalFunction) {
  const std::string levels = "levels = [-3, -2, -1, 0, 1, 2, 3]\n";
  const LoadedProcedure psi = procedure_of(
      "kind = \"psi\"\ntask = \"yes/no\"\nalpha = [-2, -1, 0, 1, 2]\nbeta = [0.5, 2]\nlapse = 0.04\n" +
      levels);
  const LoadedProcedure questplus = procedure_of(
      "kind = \"questplus\"\nfunction = \"normal\"\n" + levels +
      "parameters = { threshold = [-2, -1, 0, 1, 2], slope = [0.5, 2], guess = 0.02, lapse = 0.02 }");
  const PlayedRun one = play(psi, "1101001011"), other = play(questplus, "1101001011");
  EXPECT_EQ(one.levels, other.levels);
  const Belief belief = psi.procedure->belief(*psi.design, one.run),
               same = questplus.procedure->belief(*questplus.design, other.run);
  EXPECT_NEAR(belief.parameters[0].mean, same.parameters[0].mean, 1e-12);
  EXPECT_NEAR(belief.entropy, same.entropy, 1e-12);
}

TEST(Psi, WhatCannotBeIsRefused) {
  const auto said = [](const std::string& more) { return refusal_of_procedure("kind = \"psi\"\n" + more); };
  EXPECT_THAT(said("levels = [0, 1]\nalpha = [0, 1]\nbeta = 1"),
              HasSubstr("accepted with 2AFC: levels above 0"));
  EXPECT_THAT(said("levels = [-1, 1]\nalpha = 1\nbeta = 1"),
              HasSubstr("accepted with 2AFC: levels of 0 or above"));
  EXPECT_THAT(said("levels = [0, 1]\nalpha = 1\nbeta = 0"), HasSubstr("accepted: values above 0"));
  EXPECT_THAT(said("levels = [1, 1]\nalpha = 1\nbeta = 1"),
              HasSubstr("found 1 after 1, accepted: rising values"));
  EXPECT_THAT(said("levels = [0, 1]\nalpha = 1\nbeta = 1\ntask = \"3AFC\""), HasSubstr("2AFC, yes/no"));
}

// The observer's threshold 1 and slope 2 lie on the grid. Estimates of these 60 runs of 120 trials have an sd
// of 0.11 and 0.39, so their means have standard errors of 0.014 and 0.05; they are held within 0.05 and 0.2.
TEST(Psi, FindsAKnownObserver) {
  const LoadedProcedure loaded = procedure_of(kTwoIntervalPsi);
  Generator random = make_generator(25, "observer of psi");
  double alpha = 0.0, beta = 0.0;
  constexpr int kRuns = 60;
  for (int i = 0; i < kRuns; ++i) {
    const PlayedRun played = play_observer(loaded, 120, [&](double level) {
      return random.uniform() < 0.02 + 0.96 * phi(level * level / std::numbers::sqrt2);
    });
    const Belief belief = loaded.procedure->belief(*loaded.design, played.run);
    alpha += belief.parameters[0].mean / kRuns;
    beta += belief.parameters[1].mean / kRuns;
  }
  EXPECT_NEAR(alpha, 1.0, 0.05);
  EXPECT_NEAR(beta, 2.0, 0.2);
}

}  // namespace palpate::trials::test
