#include "analysis/statistics/beta_binomial/description.hpp"

#include <fmt/core.h>

#include <cmath>
#include <set>
#include <stdexcept>

#include "analysis/description/examinee_counts.hpp"
#include "analysis/description/phrases.hpp"
#include "analysis/numerics/to_json.hpp"
#include "analysis/statistics/beta_binomial/beta_binomial.hpp"
#include "analysis/words/words.hpp"

namespace palpate::analysis {
namespace {

using nlohmann::ordered_json;

constexpr long kMostFitted = 50'000;  // each step of the fit goes through the trials one by one: some seconds

// Rows that are alike are gone through once.
void require_few_trials(std::span<const ExamineeCount> counts) {
  std::set<std::pair<long, long>> different;
  for (const ExamineeCount& count : counts) different.insert({count.correct, count.trials});
  long trials = 0;
  for (const auto& one : different) trials += one.second;
  if (trials <= kMostFitted) return;
  throw std::invalid_argument(fmt::format(
      "{} trials in the rows that differ from each other; accepted: up to {}", trials, kMostFitted));
}

Data fitted_counts_data() {
  Data data = examinee_counts_data();
  data.columns.back().meaning += fmt::format("; up to {} in all rows that differ", kMostFitted);
  return data;
}

ordered_json json_of(const BoundedEstimate& estimate) {
  return {
      {"estimate", to_json(estimate.estimate)},
      {"standard_error", estimate.standard_error ? to_json(*estimate.standard_error) : ordered_json(nullptr)},
      {"interval", to_json(estimate.interval)}};
}

ordered_json json_of(const LikelihoodRatioTest& test) {
  return {{"g_squared", test.g_squared}, {"p", test.p}, {"reference", test.reference}};
}

ordered_json json_of(const BetaBinomial& fit) {
  return {{"procedure", "beta-binomial"},
          {"examinees", fit.examinees},
          {"correct", fit.correct},
          {"trials", fit.trials},
          {"chance", fit.options.chance},
          {"model", fit.options.corrected ? "corrected" : "plain"},
          {"mean", json_of(fit.mean)},
          {"gamma", json_of(fit.gamma)},
          {"proportion", json_of(fit.proportion)},
          {"log_likelihood", fit.log_likelihood},
          {"binomial_log_likelihood", fit.binomial_log_likelihood},
          {"overdispersion", json_of(fit.overdispersion)},
          {"tarone", {{"z", fit.tarone.z}, {"p", fit.tarone.p}}},
          {"against_chance", json_of(fit.against_chance)},
          {"method", to_json(fit.method)}};
}

std::string estimate_line(const std::string& what, const BoundedEstimate& estimate) {
  if (std::isnan(estimate.estimate)) return what + ": cannot be told, for the fit has nobody above chance\n";
  return fmt::format("{}: {} ({}{} interval {} to {})\n", what, number(estimate.estimate),
                     estimate.standard_error
                         ? fmt::format("standard error {}, ", number(*estimate.standard_error))
                         : "at an end of what can be, ",
                     short_percent(estimate.interval.level), number(estimate.interval.lower),
                     number(estimate.interval.upper));
}

std::string in_words(const BetaBinomial& fit) {
  const BoundedEstimate& share = fit.proportion;
  return fmt::format("{} of {} correct by {}; chance {}\n", fit.correct, fit.trials,
                     counted(static_cast<long>(fit.examinees), "examinee", "examinees"),
                     chance_in_words(fit.options.chance)) +
         fmt::format("Mean proportion correct: {} ({} interval {})\n", percent(share.estimate),
                     short_percent(share.interval.level), percent_range(share.interval)) +
         (fit.options.corrected ? estimate_line("Above chance, pd", fit.mean) : "") +
         estimate_line("Overdispersion gamma, 0 to 1", fit.gamma) +
         fmt::format("Against the binomial: G2 = {}, {} ({}); Tarone's Z = {}, {}\n",
                     number(fit.overdispersion.g_squared), p_in_words(fit.overdispersion.p),
                     fit.overdispersion.reference, number(fit.tarone.z), p_in_words(fit.tarone.p)) +
         fmt::format("Mean above chance: G2 = {}, {} ({})\n", number(fit.against_chance.g_squared),
                     p_in_words(fit.against_chance.p), fit.against_chance.reference) +
         fmt::format("Log-likelihood {}; of the binomial {}\n", number(fit.log_likelihood),
                     number(fit.binomial_log_likelihood)) +
         method_line(fit.method);
}

Outcome beta_binomial_outcome(const Arguments& asked) {
  const std::vector<ExamineeCount> counts = read_examinee_counts(asked.table);
  require_few_trials(counts);
  const BetaBinomial fit = beta_binomial(counts, {.chance = asked.number("chance"),
                                                  .corrected = asked.text("model") == "corrected",
                                                  .level = asked.level()});
  return {.json = json_of(fit), .text = in_words(fit)};
}

}  // namespace

Statistic beta_binomial_statistic() {
  return {
      .name = "beta-binomial",
      .question = "Are answers correct above chance, when examinees differ?",
      .title = "beta-binomial model of repeated forced-choice answers",
      .teaches =
          "Repeated answers of one examinee are not independent when examinees differ: the binomial is then "
          "too sure. The beta-binomial model lets each one's probability of a correct answer follow a beta "
          "distribution; gamma says how far they spread, from 0 (all alike: the binomial) to 1 (each one "
          "always right or always wrong). The chance-corrected model lets the part above chance follow it, "
          "so that nobody is below chance. Overdispersion is tested by likelihood ratio, at the boundary of "
          "gamma, and by Tarone's Z.",
      .inputs = {chance_input(),
                 {.name = "model",
                  .kind = Input::Kind::Choice,
                  .meaning = "Whether the part above chance follows the beta distribution, or the whole "
                             "probability",
                  .usual = "corrected",
                  .choices = {"corrected", "plain"}},
                 level_input()},
      .data = fitted_counts_data(),
      .outputs = {{"examinees", "Rows of data"},
                  {"correct", "Correct answers of all"},
                  {"trials", "Answers of all"},
                  {"chance", "Probability of a correct guess"},
                  {"model", "Model that was asked for"},
                  {"mean",
                   "of the beta distribution: above chance (corrected) or of the proportion correct; "
                   "estimate, standard_error, interval"},
                  {"gamma", "Overdispersion, the same; null where nobody is above chance"},
                  {"proportion", "Mean proportion correct, the same"},
                  {"log_likelihood", "of the model"},
                  {"binomial_log_likelihood", "of the model with gamma = 0"},
                  {"overdispersion",
                   "Likelihood-ratio test of gamma = 0: g_squared, p, reference distribution"},
                  {"tarone", "Tarone's test of the same: z, p (one-sided)"},
                  {"against_chance", "Likelihood-ratio test of the mean against chance, one-sided"}},
      .example = {{"data",
                   {{"correct", {3, 2, 6, 8, 3, 4, 6, 0, 9}}, {"trials", {10, 9, 8, 9, 8, 6, 9, 10, 10}}}},
                  {"chance", "1/2"},
                  {"model", "plain"}},
      .run = beta_binomial_outcome};
}

}  // namespace palpate::analysis
