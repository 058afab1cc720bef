#include "analysis/statistics/adjust/description.hpp"

#include <fmt/core.h>

#include <stdexcept>

#include "analysis/description/phrases.hpp"
#include "analysis/numerics/to_json.hpp"
#include "analysis/statistics/adjust/adjust.hpp"
#include "analysis/words/words.hpp"

namespace palpate::analysis {
namespace {

std::vector<double> p_values(const Arguments& asked) {
  const bool table = !asked.table.columns.empty();
  if (asked.given("p") == table) {
    throw std::invalid_argument(
        "adjust needs the p values once: either p (such as 0.01,0.03) or data, a column p");
  }
  return table ? p_value_column(asked.table, "p") : asked.numbers("p");
}

Outcome adjust_outcome(const Arguments& asked) {
  const std::vector<double> p = p_values(asked);
  const std::vector<double> by_holm = holm(p), by_hochberg = hochberg(p), by_bh = benjamini_hochberg(p);
  const Method method = {.name = "p values adjusted by Holm, Hochberg, and Benjamini & Hochberg",
                         .source = "Holm 1979; Hochberg 1988; Benjamini & Hochberg 1995"};
  Outcome outcome;
  outcome.json = {{"procedure", "adjust"},
                  {"p", p},
                  {"holm", by_holm},
                  {"hochberg", by_hochberg},
                  {"benjamini_hochberg", by_bh},
                  {"method", to_json(method)}};
  outcome.text = fmt::format("{:>12}{:>12}{:>12}{:>20}\n", "p", "Holm", "Hochberg", "Benjamini-Hochberg");
  for (std::size_t i = 0; i < p.size(); ++i) {
    outcome.text += fmt::format("{:>12}{:>12}{:>12}{:>20}\n", number(p[i]), number(by_holm[i]),
                                number(by_hochberg[i]), number(by_bh[i]));
  }
  outcome.text += method_line(method);
  return outcome;
}

}  // namespace

Statistic adjust_statistic() {
  return {
      .name = "adjust",
      .question = "Which of several tests reject, taken together?",
      .title = "p values adjusted for several tests",
      .teaches =
          "Of twenty tests at 0.05 one rejects by chance. Adjusted p values may each be held against alpha. "
          "Holm: the probability of any false rejection stays below alpha, whatever the tests. Hochberg: the "
          "same, stronger, for tests that are independent or positively dependent. Benjamini-Hochberg: the "
          "share of false rejections stays below alpha on the average, for many tests of a search. Choose "
          "one beforehand; all tests of a family go in, not only those that look well.",
      .inputs = {{.name = "p",
                  .kind = Input::Kind::PValues,
                  .meaning = "The p values, where they are not in a file",
                  .optional = true}},
      .data = {.shape = Data::Shape::Columns,
               .meaning = "one p value a row",
               .columns = {{.name = "p", .meaning = "p value of a test"}},
               .optional = true},
      .outputs = {{"p", "The p values as given"},
                  {"holm", "adjusted, in the same order"},
                  {"hochberg", "adjusted, in the same order"},
                  {"benjamini_hochberg", "adjusted, in the same order"}},
      .example = {{"p", {0.010, 0.002, 0.041, 0.300}}},
      .run = adjust_outcome};
}

}  // namespace palpate::analysis
