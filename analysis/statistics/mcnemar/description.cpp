#include "analysis/statistics/mcnemar/description.hpp"

#include <fmt/core.h>

#include <stdexcept>

#include "analysis/description/phrases.hpp"
#include "analysis/numerics/to_json.hpp"
#include "analysis/statistics/mcnemar/mcnemar.hpp"
#include "analysis/statistics/mcnemar/to_json.hpp"
#include "analysis/words/words.hpp"

namespace palpate::analysis {
namespace {

std::string in_words(const McNemarTest& test) {
  const PairedTable& table = test.table;
  return fmt::format("{} of {} discordant; the first alone is correct in {}, the second alone in {}\n",
                     test.discordant, counted(test.pairs, "pair", "pairs"), table.first_only,
                     table.second_only) +
         "Exact:      " + p_line(test.exact, Side::TwoSided) +
         "Mid-p:      " + p_line(test.mid_p, Side::TwoSided) +
         fmt::format(
             "Asymptotic: chi-squared = {}, 1 degree of freedom, {}; with continuity correction {}, {}\n",
             number(test.chi_squared), p_in_words(test.p_asymptotic), number(test.chi_squared_corrected),
             p_in_words(test.p_asymptotic_corrected)) +
         fmt::format("Difference of proportions: {}, {} interval {} ({})\n", number(test.difference),
                     short_percent(test.difference_interval.level), range(test.difference_interval),
                     test.difference_interval.method) +
         fmt::format("Odds ratio (conditional): {}, {} interval {} ({})\n", number(test.odds_ratio),
                     short_percent(test.odds_ratio_interval.level), range(test.odds_ratio_interval),
                     test.odds_ratio_interval.method) +
         method_line(test.method);
}

Outcome mcnemar_outcome(const Arguments& asked) {
  const std::vector<long> counts = asked.counts("table");
  if (counts.size() != 4) {
    throw std::invalid_argument(
        fmt::format("table has {}; accepted: four (both, first only, second only, neither)",
                    counted(static_cast<long>(counts.size()), "count", "counts")));
  }
  const McNemarTest test = mcnemar_test({counts[0], counts[1], counts[2], counts[3]}, asked.level());
  return {.json = to_json(test), .text = in_words(test)};
}

}  // namespace

Statistic mcnemar_statistic() {
  return {
      .name = "mcnemar",
      .question = "Is one of two answers to the same trials correct more often?",
      .title = "McNemar's test",
      .teaches =
          "The table counts pairs of answers to the same trials: both correct, the first only, the second "
          "only, neither. Only where the design pairs trials: two contact models that an examinee met on "
          "separate trials are compared by examinee (permutation, wilcoxon) instead. The example is that of "
          "Agresti, Categorical Data Analysis, section 10.1.",
      .inputs = {{.name = "table",
                  .kind = Input::Kind::Counts,
                  .meaning = "Counts: both, first only, second only, neither"},
                 level_input()},
      .outputs = {{"table", "The counts: both, first only, second only, neither"},
                  {"pairs", "Their sum"},
                  {"discordant", "Pairs with one correct answer: all that the test looks at"},
                  {"difference", "of the two proportions, first less second"},
                  {"difference_interval", "for it, Wald"},
                  {"odds_ratio", "conditional: first only/second only"},
                  {"odds_ratio_interval", "for it, exact"},
                  {"exact_p_values", "binomial on the discordant pairs"},
                  {"mid_p_values",
                   "the same with half of the probability of what is as likely as the outcome seen"},
                  {"chi_squared", "of the asymptotic test"},
                  {"p_asymptotic", "two-sided p value of it"},
                  {"chi_squared_corrected", "with continuity correction"},
                  {"p_asymptotic_corrected", "two-sided p value of it"},
                  {"degrees_of_freedom", "of chi-squared: 1"}},
      .example = {{"table", {794, 86, 150, 570}}},
      .run = mcnemar_outcome};
}

}  // namespace palpate::analysis
