#include "analysis/statistics/wilcoxon/description.hpp"

#include <fmt/core.h>

#include "analysis/description/phrases.hpp"
#include "analysis/description/resampled.hpp"
#include "analysis/numerics/to_json.hpp"
#include "analysis/statistics/wilcoxon/signed_rank.hpp"
#include "analysis/statistics/wilcoxon/to_json.hpp"
#include "analysis/words/words.hpp"

namespace palpate::analysis {
namespace {

std::string in_words(const SignedRankTest& test, const Interval& effect, Side side) {
  return fmt::format("{}, {} of them zero{}; V = {} of {}\n",
                     counted(static_cast<long>(test.n), "difference", "differences"), test.zeros,
                     test.ties ? ", with ties" : "", number(test.v), number(test.v_max)) +
         p_line(test.p, side) +
         fmt::format(
             "Pseudo-median {}, {} interval {} ({})\nEffect size (rank-biserial correlation): {}, {} "
             "interval {} ({})\n",
             number(test.pseudo_median), short_percent(test.interval.level), range(test.interval),
             test.interval.method, number(test.rank_biserial), short_percent(effect.level), range(effect),
             effect.method) +
         method_line(test.method);
}

Outcome wilcoxon_outcome(const Arguments& asked) {
  const std::vector<double> differences = number_column(asked.table, "difference");
  const Zeros zeros = zeros_from_name(asked.text("zeros"));
  const SignedRankTest test = signed_rank_test(differences, zeros, asked.level());
  const Interval effect = rank_biserial_interval(differences, zeros, bootstrap_options(asked));
  Outcome outcome{.json = to_json(test), .text = in_words(test, effect, asked.side())};
  outcome.json["rank_biserial_interval"] = to_json(effect);
  put_side(outcome.json, asked.side());
  return outcome;
}

}  // namespace

Statistic wilcoxon_statistic() {
  return {.name = "wilcoxon",
          .question = "Are differences centred on zero?",
          .title = "Wilcoxon's signed-rank test",
          .teaches =
              "Ranks the differences by size and adds up the ranks of the positive ones. It asks for "
              "differences that are symmetric about zero when there is no effect. Exact with ties and "
              "zeros up to 500 differences.",
          .inputs = {side_input("two-sided"),
                     {.name = "zeros",
                      .kind = Input::Kind::Choice,
                      .meaning = "Zeros: drop (Wilcoxon 1945) or pratt (ranked, then left out)",
                      .usual = "pratt",
                      .choices = {"drop", "pratt"}},
                     resamples_input(),
                     seed_input(),
                     level_input()},
          .data = difference_data("One thing less the other, for each examinee"),
          .outputs = {{"n", "Differences given"},
                      {"zeros", "of them 0"},
                      {"ties", "Whether magnitudes are equal"},
                      {"zeros_rule", "What was done about zeros"},
                      {"v", "V: the sum of the ranks of positive differences"},
                      {"v_max", "The sum of all ranks"},
                      {"rank_biserial", "Effect size, -1 to 1"},
                      {"rank_biserial_interval", "for it, percentile bootstrap"},
                      {"side", "Alternative that was asked for"},
                      {"p", "p value of that side"},
                      {"p_values", "of all three sides"},
                      {"exact", "false: normal approximation"},
                      {"pseudo_median", "Hodges-Lehmann estimate of the centre"},
                      {"interval", "for the centre"}},
          .example = {{"data", {{"difference", {3, 1, 2, -1, 4, 2, 0, 3, 1, 2}}}}, {"zeros", "pratt"}},
          .run = wilcoxon_outcome};
}

}  // namespace palpate::analysis
