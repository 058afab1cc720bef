#include "analysis/statistics/glmm/description.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <stdexcept>

#include "analysis/description/phrases.hpp"
#include "analysis/mixed/population.hpp"
#include "analysis/numerics/rounding.hpp"
#include "analysis/numerics/to_json.hpp"
#include "analysis/words/words.hpp"

namespace palpate::analysis {
namespace {

using nlohmann::ordered_json;

// Either a column of single answers, or counts.
std::vector<LevelAnswers> read_answers(const DataTable& table) {
  const bool single = has_column(table, "response");
  const bool counts = has_column(table, "correct") || has_column(table, "trials");
  if (single == counts) {
    throw std::invalid_argument(fmt::format(
        "{}: {}; accepted: a column response (0 or 1), or the columns correct and trials", table.source,
        single ? "both single answers and counts" : "neither single answers nor counts"));
  }
  const std::vector<std::string>& examinees = text_column(table, "examinee");
  const std::vector<double> levels = settled_values(number_column(table, "level"));
  const std::vector<long> ones = single ? binary_column(table, "response") : count_column(table, "correct");
  const std::vector<long> trials = single ? std::vector<long>(ones.size(), 1) : count_column(table, "trials");
  std::vector<LevelAnswers> answers;
  for (std::size_t row = 0; row < ones.size(); ++row) {
    if (trials[row] < 1 || ones[row] < 0 || ones[row] > trials[row]) {
      throw std::invalid_argument(fmt::format("{}: {} of {}; accepted: 0 to all of at least one trial",
                                              place_of(table, row), ones[row], trials[row]));
    }
    answers.push_back(
        {.examinee = examinees[row], .level = levels[row], .ones = ones[row], .trials = trials[row]});
  }
  return answers;
}

ordered_json json_of(const Coefficient& coefficient) {
  return {{"estimate", to_json(coefficient.estimate)},
          {"standard_error", to_json(coefficient.standard_error)},
          {"z", to_json(coefficient.z)},
          {"p", to_json(coefficient.p)},
          {"interval", to_json(coefficient.interval)}};
}

ordered_json json_of(const LevelEstimate& level) {
  return {{"estimate", to_json(level.estimate)},
          {"standard_error", to_json(level.standard_error)},
          {"interval", to_json(level.interval)}};
}

ordered_json json_of(const RandomSpread& spread) {
  const auto or_null = [](const std::optional<double>& value) {
    return value ? to_json(*value) : ordered_json(nullptr);
  };
  return {{"intercept_sd", spread.intercept},
          {"slope_sd", or_null(spread.slope)},
          {"correlation", or_null(spread.correlation)}};
}

ordered_json json_of(const GlmmAnalysis& result) {
  const GlmmFit& fit = result.fit;
  const Convergence& convergence = fit.convergence;
  return {{"procedure", "glmm"},
          {"examinees", result.examinees},
          {"rows", result.rows},
          {"trials", result.trials},
          {"link", name_of(fit.options.link)},
          {"random", fit.options.random == RandomEffects::Slope ? "slope" : "intercept"},
          {"nodes", fit.options.nodes},
          {"intercept", json_of(result.intercept)},
          {"slope", json_of(result.slope)},
          {"covariance", to_json(fit.covariance(0, 1))},
          {"between_examinees", json_of(fit.spread)},
          {"slope_test",
           {{"chi_squared", result.slope_test.chi_squared},
            {"degrees_of_freedom", result.slope_test.degrees_of_freedom},
            {"p", result.slope_test.p},
            {"converged", result.slope_test.converged}}},
          {"pse", json_of(result.pse)},
          {"jnd", json_of(result.jnd)},
          {"log_likelihood", fit.log_likelihood},
          {"parameters", fit.parameters},
          {"aic", 2 * fit.parameters - 2 * fit.log_likelihood},
          {"convergence",
           {{"converged", convergence.converged},
            {"singular", fit.singular},
            {"reason", convergence.reason},
            {"evaluations", convergence.evaluations},
            {"remaining", to_json(convergence.remaining)}}},
          {"method", to_json(result.method)}};
}

std::string spread_line(const RandomSpread& spread) {
  std::string line =
      fmt::format("Between examinees: standard deviation {} of the intercept", number(spread.intercept));
  if (spread.slope) line += fmt::format(", {} of the slope", number(*spread.slope));
  if (spread.correlation) line += fmt::format(", correlation {}", decimals(*spread.correlation, 2));
  return line + "\n";
}

// Which end of what can be the differences between examinees are at.
std::string singular_line(const GlmmFit& fit) {
  if (!fit.singular) return "";
  constexpr double kNothing = 1e-6;  // of the predictor's scale
  const RandomSpread& spread = fit.spread;
  const double slope = spread.slope.value_or(0.0) * fit.standardised.scale;
  if (spread.correlation && spread.intercept > kNothing && slope > kNothing)
    return fmt::format(
        "The correlation between examinees is estimated as {}, the {} that it can be: intercept and slope "
        "differ together, as one.\n",
        decimals(*spread.correlation, 0), *spread.correlation < 0 ? "least" : "most");
  if (!spread.slope) return "The variance between examinees is estimated as 0, the least that it can be.\n";
  return fmt::format(
      "The variance of the {} between examinees is estimated as 0, the least that it can be.\n",
      slope > kNothing              ? "intercept"
      : spread.intercept > kNothing ? "slope"
                                    : "intercept and the slope");
}

std::string in_words(const GlmmAnalysis& result) {
  const auto coefficient = [](const char* name, const Coefficient& of) {
    return fmt::format("{} {} (standard error {}, {} interval {}, {})\n", name, number(of.estimate),
                       number(of.standard_error), short_percent(of.interval.level), range(of.interval),
                       p_in_words(of.p));
  };
  const auto level = [](const char* name, const LevelEstimate& of) {
    return fmt::format("{}: {} (standard error {}, {} interval {} by Fieller's theorem)\n", name,
                       number(of.estimate), number(of.standard_error), short_percent(of.interval.level),
                       range(of.interval));
  };
  const Convergence& convergence = result.fit.convergence;
  return fmt::format("{} of {}\n", counted(result.trials, "answer", "answers"),
                     counted(static_cast<long>(result.examinees), "examinee", "examinees")) +
         (convergence.converged ? "" : "NOT CONVERGED: the estimates are not to be relied on.\n") +
         coefficient("Intercept", result.intercept) + coefficient("Slope", result.slope) +
         spread_line(result.fit.spread) + singular_line(result.fit) +
         fmt::format("Slope against 0: chi-squared {}, df {}, {} (likelihood ratio{})\n",
                     number(result.slope_test.chi_squared), result.slope_test.degrees_of_freedom,
                     p_in_words(result.slope_test.p),
                     result.slope_test.converged ? "" : "; not to be relied on: a fit did not converge") +
         level("PSE, where either answer is as likely", result.pse) +
         level("JND, from there to 75 %", result.jnd) +
         fmt::format("Log-likelihood {} with {} parameters; {}: {}\n", number(result.fit.log_likelihood),
                     result.fit.parameters, convergence.converged ? "converged" : "not converged",
                     convergence.reason) +
         method_line(result.method);
}

Outcome glmm_outcome(const Arguments& asked) {
  const GlmmAnalysis result = glmm_analysis(
      read_answers(asked.table),
      {.link = link_from_name(asked.text("link")),
       .random = asked.text("random") == "slope" ? RandomEffects::Slope : RandomEffects::Intercept,
       .nodes = static_cast<int>(std::clamp(asked.count("nodes"), 0L, 1000L))},
      asked.level());
  return {.json = json_of(result), .text = in_words(result)};
}

std::vector<Input> glmm_inputs() {
  return {{.name = "link",
           .kind = Input::Kind::Choice,
           .meaning = "Scale on which the answers follow the level",
           .usual = "probit",
           .choices = {"probit", "logit"}},
          {.name = "random",
           .kind = Input::Kind::Choice,
           .meaning = "What differs between examinees: the intercept, or intercept and slope (correlated)",
           .usual = "intercept",
           .choices = {"intercept", "slope"}},
          {.name = "nodes",
           .kind = Input::Kind::Count,
           .meaning = "Quadrature nodes for each random effect: 1 (Laplace) to 50, to 25 with a random slope",
           .usual = "9"},
          level_input()};
}

Data data() {
  return {
      .shape = Data::Shape::Columns,
      .meaning = "one answer a row, or the counts of one examinee at one level",
      .columns = {{.name = "examinee", .meaning = "Who answered: any text"},
                  {.name = "level", .meaning = "Of the stimulus"},
                  {.name = "response", .meaning = "The answer: 0 or 1, or false or true", .optional = true},
                  {.name = "correct", .meaning = "Or: answers that were 1", .optional = true},
                  {.name = "trials", .meaning = "of so many", .optional = true}}};
}

std::vector<Output> glmm_outputs() {
  return {
      {"examinees", "How many answered"},
      {"rows", "Rows of data"},
      {"trials", "All answers"},
      {"link", "Link function"},
      {"random", "What differs between examinees"},
      {"nodes", "Quadrature nodes for each random effect"},
      {"intercept", "on the link's scale: estimate, standard_error, z, p (two-sided), Wald interval"},
      {"slope", "per unit of the level, the same"},
      {"covariance", "of the estimates of intercept and slope"},
      {"between_examinees", "Standard deviations of the random effects and their correlation"},
      {"slope_test", "Likelihood-ratio test of a slope of 0"},
      {"pse", "Level at which either answer is as likely, for random effects of 0; Fieller's interval"},
      {"jnd", "Distance from there to 75 %; Fieller's interval"},
      {"log_likelihood", "Marginal, binomial coefficients of the rows included"},
      {"parameters", "Fixed effects and variance parameters"},
      {"aic", "Akaike's criterion"},
      {"convergence",
       "Whether the fit converged, whether a variance is 0 or a correlation 1 or -1 (singular), the reason, likelihood evaluations, "
       "and the log-likelihood that was left to gain"}};
}

}  // namespace

Statistic glmm_statistic() {
  return {
      .name = "glmm",
      .question = "How do answers follow the level in a population of examinees?",
      .title = "generalised linear mixed model of binary answers",
      .teaches =
          "Fits one psychometric function for the population and, around it, normally distributed "
          "differences between examinees, so that repeated answers of one examinee are not taken for "
          "answers of many. The answer 1 must run from never to always as the level rises or falls "
          "(\"the second was harder\"): there is no guess rate, so forced-choice answers scored as correct "
          "belong to a psychometric function with one. PSE and JND are those of an examinee in the middle "
          "of the population. With few answers an examinee, 9 nodes and more are nearer to the truth than "
          "Laplace's approximation.",
      .inputs = glmm_inputs(),
      .data = data(),
      .outputs = glmm_outputs(),
      .example = {{"data",
                   {{"examinee", {"P1", "P1", "P1", "P2", "P2", "P2", "P3", "P3", "P3", "P4", "P4", "P4"}},
                    {"level", {1, 2, 3, 1, 2, 3, 1, 2, 3, 1, 2, 3}},
                    {"correct", {1, 5, 9, 3, 6, 10, 0, 3, 8, 2, 7, 9}},
                    {"trials", {10, 10, 10, 10, 10, 10, 10, 10, 10, 10, 10, 10}}}},
                  {"link", "probit"}},
      .run = glmm_outcome};
}

}  // namespace palpate::analysis
