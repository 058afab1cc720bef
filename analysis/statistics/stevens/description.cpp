#include "analysis/statistics/stevens/description.hpp"

#include <fmt/core.h>

#include "analysis/description/phrases.hpp"
#include "analysis/numerics/rounding.hpp"
#include "analysis/numerics/to_json.hpp"
#include "analysis/statistics/stevens/stevens.hpp"
#include "analysis/words/words.hpp"

namespace palpate::analysis {
namespace {

using nlohmann::ordered_json;

std::vector<MagnitudeEstimate> read_estimates(const DataTable& table) {
  const std::vector<std::string>& examinees = text_column(table, "examinee");
  const std::vector<double> levels = settled_values(number_column(table, "level"));
  const std::vector<double> values = number_column(table, "estimate");
  std::vector<MagnitudeEstimate> estimates;
  for (std::size_t row = 0; row < values.size(); ++row) {
    estimates.push_back({.examinee = examinees[row], .level = levels[row], .estimate = values[row]});
    at_row(table, row, [&] { validate(estimates.back()); });
  }
  return estimates;
}

ordered_json json_of(const StevensFit& fit) {
  ordered_json levels = ordered_json::array(), by_examinee = nullptr;
  for (const LevelMean& mean : fit.levels) {
    levels.push_back({{"level", mean.level},
                      {"geometric_mean", mean.geometric_mean},
                      {"examinees", mean.examinees},
                      {"estimates", mean.estimates}});
  }
  if (fit.by_examinee) {
    by_examinee = {{"examinees", fit.by_examinee->examinees},
                   {"mean", fit.by_examinee->mean},
                   {"standard_deviation", fit.by_examinee->deviation},
                   {"interval", to_json(fit.by_examinee->interval)}};
  }
  return {{"procedure", "stevens"},
          {"examinees", fit.examinees},
          {"estimates", fit.estimates},
          {"exponent", fit.exponent},
          {"standard_error", fit.standard_error},
          {"interval", to_json(fit.interval)},
          {"t", to_json(fit.t)},
          {"degrees_of_freedom", fit.degrees_of_freedom},
          {"p", to_json(fit.p)},
          {"residual_deviation", fit.residual_deviation},
          {"r_squared", fit.r_squared},
          {"levels", levels},
          {"balanced", fit.balanced},
          {"by_examinee", by_examinee},
          {"method", to_json(fit.method)}};
}

std::string in_words(const StevensFit& fit) {
  std::string text =
      fmt::format("{} of {}\n", counted(static_cast<long>(fit.estimates), "estimate", "estimates"),
                  counted(static_cast<long>(fit.examinees), "examinee", "examinees"));
  text +=
      fit.perfect
          ? fmt::format(
                "Exponent {}; every estimate lies on the line but for rounding, so that there is no "
                "spread to give an interval or a test by\n",
                number(fit.exponent))
          : fmt::format("Exponent {} (standard error {}, {} interval {}; t = {}, df {}, {} against 0)\n",
                        number(fit.exponent), number(fit.standard_error), short_percent(fit.interval.level),
                        range(fit.interval), number(fit.t), fit.degrees_of_freedom, p_in_words(fit.p));
  if (fit.by_examinee) {
    const ExponentsOfExaminees& own = *fit.by_examinee;
    text += fmt::format(
        "Exponents of the examinees: mean {}, standard deviation {}, {} interval for the mean {}\n",
        number(own.mean), number(own.deviation), short_percent(own.interval.level), range(own.interval));
  }
  for (const LevelMean& mean : fit.levels) {
    text += fmt::format("Level {}: geometric mean {} ({})\n", number(mean.level), number(mean.geometric_mean),
                        counted(static_cast<long>(mean.examinees), "examinee", "examinees"));
  }
  if (!fit.balanced) {
    text +=
        "Not every examinee judged every level: the geometric means mix levels with people; the exponent "
        "does not.\n";
  }
  return text +
         fmt::format("The line explains {} of the variance within examinees\n", percent(fit.r_squared)) +
         method_line(fit.method);
}

Outcome stevens_outcome(const Arguments& asked) {
  const StevensFit fit = stevens_fit(read_estimates(asked.table), asked.level());
  return {.json = json_of(fit), .text = in_words(fit)};
}

}  // namespace

Statistic stevens_statistic() {
  return {
      .name = "stevens",
      .question = "With what power of the level do magnitude estimates grow?",
      .title = "Stevens' exponent from magnitude estimation",
      .teaches =
          "Each examinee gives numbers in proportion to what is felt, in a unit of their own. On logarithms "
          "the power law is a straight line whose slope is the exponent; a factor for each examinee takes "
          "the units out. The first interval takes single estimates as independent and the exponent as "
          "everybody's; the mean of the examinees' own exponents, with its interval, is the claim about "
          "people like them.",
      .inputs = {level_input()},
      .data = {.shape = Data::Shape::Columns,
               .meaning = "one estimate a row",
               .columns = {{.name = "examinee", .meaning = "Who judged: any text"},
                           {.name = "level", .meaning = "Of the stimulus, above 0"},
                           {.name = "estimate", .meaning = "The number given, above 0"}}},
      .outputs = {{"examinees", "How many judged"},
                  {"estimates", "Rows of data"},
                  {"exponent", "Stevens' exponent"},
                  {"standard_error", "of the exponent"},
                  {"interval", "for the exponent, Student's t"},
                  {"t", "of an exponent of 0"},
                  {"degrees_of_freedom", "of t: estimates less examinees less 1"},
                  {"p", "two-sided"},
                  {"residual_deviation", "Standard deviation of log estimates about the line"},
                  {"r_squared", "Effect size: share of the variance within examinees that the line explains"},
                  {"levels", "Geometric mean over examinees at each level, with how many judged it"},
                  {"balanced", "Whether every examinee judged every level"},
                  {"by_examinee",
                   "Mean and standard deviation of the examinees' own exponents, with an interval "
                   "for the mean; null below two examinees"}},
      .example = {{"data",
                   {{"examinee", {"P1", "P1", "P1", "P2", "P2", "P2", "P3", "P3", "P3"}},
                    {"level", {1, 2, 4, 1, 2, 4, 1, 2, 4}},
                    {"estimate", {10, 18, 30, 2, 3, 7, 50, 90, 140}}}}},
      .run = stevens_outcome};
}

}  // namespace palpate::analysis
