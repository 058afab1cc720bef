#include "analysis/statistics/bradley_terry/description.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "analysis/description/phrases.hpp"
#include "analysis/numerics/to_json.hpp"
#include "analysis/statistics/bradley_terry/bradley_terry.hpp"
#include "analysis/words/words.hpp"

namespace palpate::analysis {
namespace {

using nlohmann::ordered_json;

std::vector<Comparison> read_comparisons(const DataTable& table) {
  const std::vector<std::string>&winners = text_column(table, "winner"),
        &losers = text_column(table, "loser");
  const std::vector<long> counts =
      has_column(table, "count") ? count_column(table, "count") : std::vector<long>(winners.size(), 1);
  std::vector<Comparison> comparisons;
  for (std::size_t row = 0; row < winners.size(); ++row) {
    if (counts[row] == 0) continue;  // a table of all pairs has such cells
    comparisons.push_back({.winner = winners[row], .loser = losers[row], .count = counts[row]});
    at_row(table, row, [&] { validate(comparisons.back()); });
  }
  return comparisons;
}

ordered_json json_of(const ChiSquaredTest& test) {
  return {{"g_squared", test.chi_squared},
          {"degrees_of_freedom", test.degrees_of_freedom},
          {"p", test.p ? to_json(*test.p) : ordered_json(nullptr)}};
}

ordered_json json_of(const PairedScaling& result) {
  ordered_json items = ordered_json::array();
  for (const ScaledItem& item : result.items) {
    items.push_back({{"name", item.name},
                     {"wins", item.wins},
                     {"losses", item.losses},
                     {"estimate", item.value},
                     {"standard_error", item.standard_error},
                     {"interval", to_json(item.interval)}});
  }
  return {{"procedure", "bradley-terry"},
          {"model", name_of(result.model)},
          {"reference", result.reference ? ordered_json(*result.reference) : ordered_json(nullptr)},
          {"comparisons", result.comparisons},
          {"items", items},
          {"covariance", result.covariance},
          {"log_likelihood", result.log_likelihood},
          {"goodness_of_fit", json_of(result.goodness_of_fit)},
          {"equality", json_of(result.equality)},
          {"converged", result.converged},
          {"method", to_json(result.method)}};
}

std::string test_line(const char* what, const ChiSquaredTest& test) {
  return fmt::format("{}: G2 = {}, df {}, {}\n", what, number(test.chi_squared), test.degrees_of_freedom,
                     test.p ? p_in_words(*test.p) : "no p value: nothing is left to test");
}

std::string in_words(const PairedScaling& result) {
  std::vector<ScaledItem> items = result.items;
  std::ranges::stable_sort(
      items, [](const ScaledItem& one, const ScaledItem& other) { return one.value > other.value; });
  std::string text = fmt::format(
      "{} of {} items; {}\n", counted(result.comparisons, "comparison", "comparisons"), items.size(),
      result.reference ? fmt::format("'{}' is 0", *result.reference) : "the mean of the values is 0");
  for (const ScaledItem& item : items) {
    text += fmt::format("{}: {} (standard error {}, {} interval {}; {} won, {} lost)\n", item.name,
                        decimals(item.value, 3), decimals(item.standard_error, 3),
                        short_percent(item.interval.level), range(item.interval), item.wins, item.losses);
  }
  return text + test_line("All values alike", result.equality) +
         test_line("Fit of the model", result.goodness_of_fit) +
         (result.converged ? "" : "NOT CONVERGED: the values are not to be relied on.\n") +
         method_line(result.method);
}

Outcome bradley_terry_outcome(const Arguments& asked) {
  std::optional<std::string> reference;
  if (asked.given("reference")) reference = asked.text("reference");
  const PairedScaling result = paired_scaling(
      read_comparisons(asked.table), scale_model_from_name(asked.text("model")), reference, asked.level());
  return {.json = json_of(result), .text = in_words(result)};
}

}  // namespace

Statistic bradley_terry_statistic() {
  return {.name = "bradley-terry",
          .question = "Where do things stand on one scale, by paired comparisons?",
          .title = "Bradley-Terry model or Thurstone's case V",
          .teaches =
              "Each answer says which of two things has more of something. The model gives each thing a "
              "value; the probability of an answer follows the difference of two values, by the logistic "
              "function (Bradley-Terry) or the cumulative Gaussian (Thurstone's case V, in standard "
              "deviations of a difference). It takes the answers as independent: many answers of one "
              "examinee make it too sure. A large G2 for the fit says that one scale does not hold all "
              "pairs.",
          .inputs = {{.name = "model",
                      .kind = Input::Kind::Choice,
                      .meaning = "Function of the difference: logistic or cumulative Gaussian",
                      .usual = "bradley-terry",
                      .choices = {"bradley-terry", "thurstone"}},
                     {.name = "reference",
                      .kind = Input::Kind::Text,
                      .meaning = "Item whose value is 0; without it the mean of the values is 0",
                      .optional = true},
                     level_input()},
          .data = {.shape = Data::Shape::Columns,
                   .meaning = "one comparison a row, or so many with the same outcome",
                   .columns = {{.name = "winner", .meaning = "What was chosen"},
                               {.name = "loser", .meaning = "What was not"},
                               {.name = "count",
                                .meaning = "How often; 1 where the column is absent",
                                .optional = true}}},
          .outputs = {{"model", "Model that was asked for"},
                      {"reference", "Item whose value is 0; null: the mean is 0"},
                      {"comparisons", "All comparisons"},
                      {"items",
                       "name, wins, losses, estimate, standard_error and Wald interval of each, by name"},
                      {"covariance", "of the estimates, in the items' order"},
                      {"log_likelihood", "of the comparisons in their order"},
                      {"goodness_of_fit", "G2 of the model against a probability of its own for every pair"},
                      {"equality", "G2 of all values alike against the model"},
                      {"converged", "Whether the fit settled"}},
          .example = {{"data",
                       {{"winner", {"hard", "hard", "firm", "firm", "soft", "soft"}},
                        {"loser", {"firm", "soft", "hard", "soft", "hard", "firm"}},
                        {"count", {14, 18, 6, 15, 2, 5}}}},
                      {"reference", "soft"}},
          .run = bradley_terry_outcome};
}

}  // namespace palpate::analysis
