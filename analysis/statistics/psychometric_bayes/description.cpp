#include "analysis/statistics/psychometric_bayes/description.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <stdexcept>

#include "analysis/description/phrases.hpp"
#include "analysis/description/read_number.hpp"
#include "analysis/numerics/to_json.hpp"
#include "analysis/psychometric/bayes.hpp"
#include "analysis/psychometric/fit.hpp"
#include "analysis/psychometric/request.hpp"
#include "analysis/words/words.hpp"

namespace palpate::analysis {
namespace {

using nlohmann::ordered_json;

ordered_json posterior_json(const Posterior& posterior) {
  return {{"mean", posterior.mean}, {"mode", posterior.mode}, {"interval", to_json(posterior.interval)}};
}

std::string posterior_line(const std::string& what, const Posterior& posterior) {
  return fmt::format("{}: {} (posterior mean; mode {}); {} credible interval {}\n", what,
                     number(posterior.mean), number(posterior.mode), short_percent(posterior.interval.level),
                     range(posterior.interval));
}

std::optional<double> guess_of(const Arguments& asked) {
  const std::string guess = asked.text("guess");
  if (guess == "free") return std::nullopt;
  const auto fixed = read_fraction(guess);
  if (fixed) return fixed;
  throw std::invalid_argument(
      fmt::format("guess is '{}'; accepted: free, a fraction such as 1/2 or a number such as 0.5", guess));
}

ordered_json unanswered(const std::string& why) {
  return {{"procedure", "psychometric-bayes"}, {"status", "unfit levels"}, {"why", why}};
}

// As `psychometric` judges it: whether a slope of 0 is as likely as any other.
bool rises(const std::vector<Block>& blocks, Shape shape, const std::optional<double>& guess) {
  PsychometricModel model{.shape = shape, .guess = guess.value_or(0.0)};
  if (!guess || unfit_levels(blocks, model)) model.lapse_upper = 0;
  model.lapse_upper = std::min(model.lapse_upper, 0.5 * (1 - model.guess));
  const Design design = make_design(blocks, model);
  return fit_psychometric(design, correct_in(design, blocks)).kind != FitKind::Flat;
}

constexpr const char* kNoRise =
    "the answers do not rise with the level: a slope of 0 is as likely as any other, and what is given of "
    "threshold and width is the priors' saying";

Outcome psychometric_bayes_outcome(const Arguments& asked) {
  const std::vector<Block> blocks = blocks_of(asked.table);
  const Shape shape = shape_from_name(asked.text("shape"));
  const std::optional<double> guess = guess_of(asked);
  const Method method{.name = "Bayesian beta-binomial psychometric function over a grid",
                      .source = "Schuett et al. 2016"};
  if (const auto unfit = unfit_levels(blocks, {.shape = shape, .guess = 0, .lapse_upper = 0})) {
    Outcome none{.json = unanswered(*unfit), .text = fmt::format("No function: {}.\n", *unfit)};
    none.json["method"] = to_json(method);
    return none;
  }
  const BayesianFit fit = bayesian_psychometric(blocks, shape, guess, asked.level());  // refuses a guess
  const bool rising = rises(blocks, shape, guess);
  Outcome outcome{.json = {{"procedure", "psychometric-bayes"},
                           {"status", rising ? "fitted" : "no rise"},
                           {"why", rising ? ordered_json(nullptr) : ordered_json(kNoRise)},
                           {"shape", name_of(shape)},
                           {"threshold", posterior_json(fit.threshold)},
                           {"width", posterior_json(fit.width)},
                           {"lapse", posterior_json(fit.lapse)},
                           {"guess", fit.guess ? posterior_json(*fit.guess) : ordered_json(*guess)},
                           {"eta", posterior_json(fit.eta)},
                           {"priors", fit.priors},
                           {"grid", fit.grid},
                           {"method", to_json(method)}}};
  outcome.text =
      (rising ? "" : fmt::format("No rise: {}.\n", kNoRise)) +
      posterior_line("Threshold (level at F = 0.5)", fit.threshold) +
      posterior_line(on_log_levels(shape) ? "Width (from F = 0.05 to F = 0.95, in log level)"
                                          : "Width (from F = 0.05 to F = 0.95)",
                     fit.width) +
      posterior_line("Lapse rate", fit.lapse) +
      (fit.guess ? posterior_line("Guess rate", *fit.guess)
                 : fmt::format("Guess rate: {}, fixed\n", *guess == 0 ? "0" : chance_in_words(*guess))) +
      posterior_line("Overdispersion eta (0: binomial)", fit.eta) + "Priors:\n";
  for (const std::string& prior : fit.priors) outcome.text += fmt::format("  {}\n", prior);
  outcome.text += method_line(method);
  return outcome;
}

}  // namespace

Statistic psychometric_bayes_statistic() {
  return {.name = "psychometric-bayes",
          .question = "What do few answers, with priors, say of threshold and width?",
          .title = "Bayesian psychometric function",
          .teaches =
              "The model and the priors of psignifit 4: thresholds and widths that the levels could not show "
              "are unlikely beforehand, so that sparse or separable answers still give an estimate and an "
              "honest interval. Blocks may vary more than binomially (eta). Where answers are few the result "
              "depends on the priors, which are part of it; they take the levels to be chosen well.",
          .inputs = {shape_input(),
                     {.name = "guess",
                      .kind = Input::Kind::Text,
                      .meaning = "psi far below threshold: a fraction, or free for yes-no tasks",
                      .usual = "1/2"},
                     {.name = "level",
                      .kind = Input::Kind::Fraction,
                      .meaning = "Posterior probability of the credible intervals",
                      .usual = "0.95"}},
          .data = block_data(),
          .outputs = {{"status", "fitted, no rise, or unfit levels"},
                      {"why", "why there is no function; null where fitted"},
                      {"shape", "Form of F"},
                      {"threshold", "level at F = 0.5: posterior mean, mode, credible interval"},
                      {"width", "from F = 0.05 to F = 0.95, in log level for the Weibull function"},
                      {"lapse", "lapse rate"},
                      {"guess", "guess rate: a number where fixed"},
                      {"eta", "overdispersion: a block's proportion varies by eta sqrt(psi (1 - psi))"},
                      {"priors", "in words"},
                      {"grid", "functions whose posterior was added up"}},
          .example = {{"data",
                       {{"level", {1, 2, 3, 4, 5}},
                        {"correct", {5, 6, 8, 10, 10}},
                        {"trials", {10, 10, 10, 10, 10}}}},
                      {"guess", "1/2"}},
          .run = psychometric_bayes_outcome};
}

}  // namespace palpate::analysis
