#include "analysis/statistics/friedman/description.hpp"

#include <fmt/core.h>

#include "analysis/description/phrases.hpp"
#include "analysis/description/resampled.hpp"
#include "analysis/numerics/to_json.hpp"
#include "analysis/statistics/friedman/friedman.hpp"
#include "analysis/words/words.hpp"

namespace palpate::analysis {
namespace {

using nlohmann::ordered_json;

ordered_json as_json(const FriedmanTest& test, const std::vector<std::string>& names) {
  ordered_json columns = ordered_json::array();
  for (std::size_t j = 0; j < names.size(); ++j) {
    columns.push_back({{"name", names[j]}, {"mean_rank", test.mean_ranks[j]}});
  }
  return {{"procedure", "friedman"},
          {"n", test.n},
          {"columns", columns},
          {"ties", test.ties},
          {"chi_squared", test.chi_squared},
          {"degrees_of_freedom", test.degrees_of_freedom},
          {"p_asymptotic", test.p_asymptotic},
          {"p_exact", test.p_exact ? ordered_json(*test.p_exact) : ordered_json(nullptr)},
          {"kendall_w", to_json(test.kendall_w)},
          {"kendall_w_interval", to_json(test.w_interval)},
          {"method", to_json(test.method)}};
}

std::string in_words(const FriedmanTest& test, const std::vector<std::string>& names) {
  std::string text = fmt::format("{} examinees, {} things{}; mean ranks (1: smallest):\n", test.n,
                                 names.size(), test.ties ? ", with ties" : "");
  for (std::size_t j = 0; j < names.size(); ++j) {
    text += fmt::format("  {}: {}\n", names[j], decimals(test.mean_ranks[j], 2));
  }
  return text +
         fmt::format("chi-squared = {}, {}: {} asymptotic, {}\n", number(test.chi_squared),
                     counted(test.degrees_of_freedom, "degree of freedom", "degrees of freedom"),
                     p_in_words(test.p_asymptotic),
                     test.p_exact ? p_in_words(*test.p_exact) + " exact" : "too large for the exact test") +
         fmt::format("Kendall's W = {}, {} interval {} ({})\n", number(test.kendall_w),
                     short_percent(test.w_interval.level), range(test.w_interval), test.w_interval.method) +
         method_line(test.method);
}

Outcome friedman_outcome(const Arguments& asked) {
  const std::vector<std::string> names = matrix_names(asked.table);
  const FriedmanTest test = friedman_test(number_columns(asked.table), bootstrap_options(asked));
  return {.json = as_json(test, names), .text = in_words(test, names)};
}

}  // namespace

Statistic friedman_statistic() {
  return {
      .name = "friedman",
      .question = "Do examinees rank several things alike?",
      .title = "Friedman's test with Kendall's W",
      .teaches =
          "Each examinee's values are ranked among themselves, so it asks for no scale that examinees share. "
          "If the things do not differ, every order is equally likely for each examinee. The exact p value "
          "counts all orders where they can be counted; it is the one to report for few examinees. Kendall's "
          "W says how far the examinees agree: 0 not at all, 1 wholly; its bootstrap interval cannot reach 0 "
          "and lies too high where W is small. Compare pairs by wilcoxon, adjusted by adjust.",
      .inputs = {resamples_input(), seed_input(), level_input()},
      .data = {.shape = Data::Shape::Matrix,
               .meaning = "a column for each thing compared; a row each examinee"},
      .outputs = {{"n", "Examinees"},
                  {"columns", "Of each its name and mean rank; the smallest value has rank 1"},
                  {"ties", "Whether an examinee has equal values"},
                  {"chi_squared", "corrected for ties"},
                  {"degrees_of_freedom", "Columns less one"},
                  {"p_asymptotic", "by the chi-squared distribution"},
                  {"p_exact", "over all orders within examinees; null where they are too many"},
                  {"kendall_w", "Agreement, 0 to 1; null where everything is tied"},
                  {"kendall_w_interval", "for it, percentile bootstrap over examinees"}},
      .example = {{"data",
                   {{"none", {2.1, 1.8, 2.5, 1.9, 2.2, 2.0, 2.4, 1.7}},
                    {"sibille", {2.6, 2.0, 2.4, 2.3, 2.2, 2.5, 2.9, 2.1}},
                    {"kuroda", {3.0, 2.4, 2.9, 2.2, 2.8, 2.6, 2.7, 2.5}}}}},
      .run = friedman_outcome};
}

}  // namespace palpate::analysis
