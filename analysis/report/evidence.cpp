#include "analysis/report/evidence.hpp"

#include <fmt/core.h>

#include <cmath>

#include "analysis/words/words.hpp"

namespace palpate::analysis {
namespace {

std::string factor_in_words(const BayesFactor& factor) {
  return fmt::format("The Bayes factor for chance is {:.2g}: {}.", std::exp(-factor.log_bayes_factor),
                     evidence_in_words(factor.log_bayes_factor));
}

}  // namespace

EvidenceForChance evidence_for_chance(const PrimaryTest& test, double level) {
  EvidenceForChance evidence{
      .bayes = bayes_factor(test.correct, test.trials, test.chance, test.side, BetaPrior{}, level)};
  if (test.side != Side::Less)
    evidence.similarity = similarity_test(test.correct, test.trials, test.chance,
                                          proportion_at(kSimilarBelow, test.chance), 1 - level);
  return evidence;
}

std::string in_words(const EvidenceForChance& evidence) {
  std::string text;
  if (evidence.similarity) {
    const SimilarityTest& test = *evidence.similarity;
    text =
        test.discriminators_up_to >= 1.0
            ? std::string("Any share of the presentations may have been told apart.")
            : fmt::format(
                  "At most {} of the presentations were told apart and not guessed (one-sided {} bound), {} ({}).",
                  percent(test.discriminators_up_to), short_percent(1 - test.alpha),
                  test.similar
                      ? fmt::format("so the conditions count as similar where {} may be",
                                    short_percent(test.bound_discriminators))
                      : fmt::format(
                            "so it is not shown either that they are similar, which takes less than {}",
                            short_percent(test.bound_discriminators)),
                  p_in_words(test.p));
  }
  return text + (text.empty() ? "" : " ") + factor_in_words(evidence.bayes);
}

}  // namespace palpate::analysis
