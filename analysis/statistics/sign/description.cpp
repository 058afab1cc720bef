#include "analysis/statistics/sign/description.hpp"

#include <fmt/core.h>

#include "analysis/description/phrases.hpp"
#include "analysis/numerics/to_json.hpp"
#include "analysis/statistics/sign/sign_test.hpp"
#include "analysis/statistics/sign/to_json.hpp"
#include "analysis/words/words.hpp"

namespace palpate::analysis {
namespace {

std::string in_words(const SignTest& test, Side side) {
  return fmt::format("{}: {} positive, {} negative, {} zero\n",
                     counted(static_cast<long>(test.n), "difference", "differences"), test.positive,
                     test.negative, test.zeros) +
         p_line(test.p, side) +
         fmt::format("Positive among those not zero: {}, {} interval {}\n", percent(test.share_positive),
                     short_percent(test.share_interval.level), percent_range(test.share_interval)) +
         fmt::format("Median {}, {} interval {} ({})\n", number(test.median),
                     short_percent(test.interval.level), range(test.interval), test.interval.method) +
         method_line(test.method);
}

Outcome sign_outcome(const Arguments& asked) {
  const SignTest test = sign_test(number_column(asked.table, "difference"), asked.level());
  Outcome outcome{.json = to_json(test), .text = in_words(test, asked.side())};
  put_side(outcome.json, asked.side());
  return outcome;
}

}  // namespace

Statistic sign_statistic() {
  return {
      .name = "sign",
      .question = "Are differences more often positive than negative?",
      .title = "sign test",
      .teaches =
          "Looks at nothing but the signs, so it asks for no more than independent differences. "
          "Zeros are left out of the test and kept in the median.",
      .inputs = {side_input("two-sided"), level_input()},
      .data = difference_data("One thing less the other, for each examinee"),
      .outputs = {{"n", "Differences given"},
                  {"positive", "of them above 0"},
                  {"negative", "of them below 0"},
                  {"zeros", "of them 0"},
                  {"side", "Alternative that was asked for"},
                  {"p", "p value of that side"},
                  {"p_values", "of all three sides"},
                  {"share_positive", "Effect size: positive/(positive + negative); null where all are zero"},
                  {"share_interval", "for it, Clopper-Pearson"},
                  {"median", "of the differences"},
                  {"interval", "for the median, by order statistics"}},
      .example = {{"data", {{"difference", {3, 1, 2, -1, 4, 2, 0, 3, 1, 2}}}}, {"side", "greater"}},
      .run = sign_outcome};
}

}  // namespace palpate::analysis
