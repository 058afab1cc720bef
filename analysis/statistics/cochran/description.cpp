#include "analysis/statistics/cochran/description.hpp"

#include <fmt/core.h>

#include "analysis/description/phrases.hpp"
#include "analysis/description/resampled.hpp"
#include "analysis/numerics/to_json.hpp"
#include "analysis/statistics/cochran/cochran.hpp"
#include "analysis/words/words.hpp"

namespace palpate::analysis {
namespace {

using nlohmann::ordered_json;

ordered_json as_json(const CochranTest& test, const std::vector<std::string>& names) {
  ordered_json columns = ordered_json::array();
  for (std::size_t j = 0; j < names.size(); ++j) {
    columns.push_back(
        {{"name", names[j]}, {"proportion", test.proportions[j]}, {"interval", to_json(test.intervals[j])}});
  }
  return {{"procedure", "cochran"},
          {"n", test.n},
          {"informative", test.informative},
          {"columns", columns},
          {"q", test.q},
          {"degrees_of_freedom", test.degrees_of_freedom},
          {"p_asymptotic", test.p_asymptotic},
          {"p_exact", test.p_exact ? ordered_json(*test.p_exact) : ordered_json(nullptr)},
          {"eta_squared", test.eta_squared},
          {"eta_squared_interval", to_json(test.eta_squared_interval)},
          {"method", to_json(test.method)}};
}

std::string in_words(const CochranTest& test, const std::vector<std::string>& names) {
  std::string text = fmt::format("{}, {} of them with different answers\n",
                                 counted(static_cast<long>(test.n), "row", "rows"), test.informative);
  for (std::size_t j = 0; j < names.size(); ++j) {
    text += fmt::format("{}: {} correct, {} interval {}\n", names[j], percent(test.proportions[j]),
                        short_percent(test.intervals[j].level), percent_range(test.intervals[j]));
  }
  return text +
         fmt::format("Q = {}, {}: {} asymptotic, {}\n", number(test.q),
                     counted(test.degrees_of_freedom, "degree of freedom", "degrees of freedom"),
                     p_in_words(test.p_asymptotic),
                     test.p_exact ? p_in_words(*test.p_exact) + " exact" : "too large for the exact test") +
         fmt::format("Effect size eta-squared = {}, {} interval {} ({})\n", number(test.eta_squared),
                     short_percent(test.eta_squared_interval.level), range(test.eta_squared_interval),
                     test.eta_squared_interval.method) +
         method_line(test.method);
}

Outcome cochran_outcome(const Arguments& asked) {
  const std::vector<std::string> names = matrix_names(asked.table);
  const CochranTest test = cochran_test(binary_columns(asked.table), bootstrap_options(asked));
  return {.json = as_json(test, names), .text = in_words(test, names)};
}

}  // namespace

Statistic cochran_statistic() {
  return {
      .name = "cochran",
      .question = "Are proportions of the same trials or examinees equal?",
      .title = "Cochran's Q",
      .teaches =
          "McNemar's test for more than two columns of 0 (wrong) and 1 (correct), such as several contact "
          "models met by each examinee in trials that belong together by design. Only rows with different "
          "answers count. The exact p value counts all orders within rows where they can be counted; it is "
          "the one to report for few rows. The bootstrap interval of the effect size cannot reach 0 and lies "
          "too high for small effects. A Q that rejects does not say which columns differ: compare pairs by "
          "mcnemar, adjusted by adjust.",
      .inputs = {resamples_input(), seed_input(), level_input()},
      .data = {.shape = Data::Shape::Matrix,
               .meaning = "a column for each thing compared, of 0 and 1; a row each trial or examinee"},
      .outputs = {{"n", "Rows"},
                  {"informative", "of them with both 0 and 1"},
                  {"columns", "Of each its name, proportion and Clopper-Pearson interval"},
                  {"q", "Q"},
                  {"degrees_of_freedom", "Columns less one"},
                  {"p_asymptotic", "by the chi-squared distribution"},
                  {"p_exact", "over all orders within rows; null where they are too many"},
                  {"eta_squared", "Effect size Q/(n(k - 1)), 0 to 1"},
                  {"eta_squared_interval", "for it, percentile bootstrap over rows"}},
      .example = {{"data",
                   {{"none", {0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 0}},
                    {"sibille", {1, 0, 1, 0, 1, 1, 0, 0, 1, 1, 0, 0}},
                    {"kuroda", {1, 1, 1, 1, 1, 1, 0, 1, 1, 1, 0, 1}}}}},
      .run = cochran_outcome};
}

}  // namespace palpate::analysis
