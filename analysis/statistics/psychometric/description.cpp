#include "analysis/statistics/psychometric/description.hpp"

#include <fmt/core.h>

#include <cmath>
#include <limits>

#include "analysis/description/phrases.hpp"
#include "analysis/numerics/to_json.hpp"
#include "analysis/statistics/psychometric/merge_bootstrap.hpp"
#include "analysis/statistics/psychometric/psychometric_result.hpp"
#include "analysis/words/words.hpp"
#include "base/text/shard.hpp"

namespace palpate::analysis {
namespace {

using Kind = Input::Kind;
using nlohmann::ordered_json;

// The fit of a request; no fitter where the levels do not allow one.
struct Fitted {
  std::optional<Fitter> fitter{};
  PsychometricFit fit{};
};

Fitted fitted(const PsychometricRequest& request) {
  if (unfit_levels(request.blocks, request.model)) return {};
  Fitted one{.fitter = Fitter(make_design(request.blocks, request.model))};
  one.fit = one.fitter->fit(correct_in(one.fitter->design(), request.blocks));
  return one;
}

std::vector<Replicate> replicates_of(const PsychometricRequest& request, const Fitted& one, Share share) {
  if (!one.fitter || one.fit.kind != FitKind::Found || request.replicates == 0) return {};
  const Design& design = one.fitter->design();
  std::vector<double> probabilities = fitted_psi(design, one.fit);
  if (request.bootstrap == Bootstrap::NonParametric) {
    const std::vector<double> correct = correct_in(design, request.blocks);
    for (std::size_t row = 0; row < correct.size(); ++row)
      probabilities[row] = correct[row] / design.trials[row];
  }
  return bootstrap_replicates(*one.fitter, probabilities, request.seed, share);
}

Method method_of(const PsychometricRequest& request) {
  return {
      .name = fmt::format("maximum likelihood, intervals by {}",
                          request.bootstrap_intervals ? std::string(name_of(request.bootstrap)) + " bootstrap"
                                                      : "profile likelihood"),
      .source = "Wichmann & Hill 2001a, 2001b"};
}

ordered_json bootstrap_json(const PsychometricRequest& request, const std::vector<Replicate>& replicates) {
  if (replicates.empty()) return nullptr;
  long steps = 0, flat = 0;
  for (const Replicate& replicate : replicates) {
    steps += std::isinf(replicate.beta);
    flat += replicate.beta == 0;
  }
  return {{"kind", name_of(request.bootstrap)},
          {"replicates", request.replicates},
          {"seed", request.seed},
          {"separable", steps},
          {"no_rise", flat}};
}

std::string bootstrap_line(const PsychometricRequest& request, const ordered_json& bootstrap) {
  if (bootstrap.is_null()) return "";
  const long steps = bootstrap["separable"], flat = bootstrap["no_rise"];
  std::string line = fmt::format("Bootstrap: {} {} replicates, seed {}", request.replicates,
                                 name_of(request.bootstrap), request.seed);
  if (steps > 0) line += fmt::format("; {} separable, their slope counted as infinite", steps);
  if (flat > 0) line += fmt::format("; {} without a rise, counted against both ends of the threshold", flat);
  return line + '\n';
}

ordered_json values_json(const std::vector<Replicate>& replicates) {
  ordered_json values = {{"alpha", ordered_json::array()},
                         {"beta", ordered_json::array()},
                         {"lapse", ordered_json::array()},
                         {"deviance", ordered_json::array()}};
  for (const Replicate& replicate : replicates) {
    values["alpha"].push_back(to_json(replicate.alpha));
    values["beta"].push_back(to_json(replicate.beta));
    values["lapse"].push_back(to_json(replicate.lapse));
    values["deviance"].push_back(replicate.deviance);
  }
  return values;
}

Outcome outcome_of(const PsychometricRequest& request, const Fitted& one,
                   const std::vector<Replicate>& replicates) {
  const PsychometricResult result =
      psychometric_result(request, one.fitter ? &*one.fitter : nullptr, one.fit, replicates);
  Outcome outcome{.json = to_json(result), .text = in_words(result)};
  outcome.json["bootstrap"] = bootstrap_json(request, replicates);
  outcome.json["method"] = to_json(method_of(request));
  outcome.text += bootstrap_line(request, outcome.json["bootstrap"]) + method_line(method_of(request));
  return outcome;
}

Outcome asked_psychometric(const Arguments& asked) {
  const PsychometricRequest request = psychometric_request(asked);
  return asked.given("shard") ? psychometric_shard(request, shard_from_text(asked.text("shard")))
                              : psychometric_outcome(request);
}

std::vector<Input> psychometric_inputs() {
  std::vector<Input> all{shape_input(), guess_input()};
  for (const Input& input : lapse_inputs()) all.push_back(input);
  all.push_back(threshold_at_input());
  all.push_back({.name = "standard",
                 .kind = Kind::Number,
                 .meaning = "Level of the standard, for the Weber fraction",
                 .optional = true});
  all.push_back({.name = "intervals",
                 .kind = Kind::Choice,
                 .meaning = "By profile likelihood or by the bootstrap",
                 .usual = "profile",
                 .choices = {"profile", "bootstrap"}});
  all.push_back({.name = "bootstrap",
                 .kind = Kind::Choice,
                 .meaning = "Replicates from the fitted function or from the observed proportions",
                 .usual = "parametric",
                 .choices = {"parametric", "nonparametric"}});
  all.push_back({.name = "replicates",
                 .kind = Kind::Count,
                 .meaning = "Of the bootstrap, which takes up to 1000000 trials in all; 0: none",
                 .usual = "2000"});
  all.push_back(seed_input());
  all.push_back({.name = "shard",
                 .kind = Kind::Text,
                 .meaning = "K/N: only the K-th of N shares of the replicates, to be merged",
                 .optional = true});
  all.push_back(level_input());
  return all;
}

std::vector<Output> psychometric_outputs() {
  return {
      {"status", "fitted, separable (infinite slope), no rise, or unfit levels"},
      {"why", "why there is no function; null where fitted"},
      {"shape", "Form of F"},
      {"formula", "F in alpha and beta"},
      {"n", "All answers"},
      {"guess", "psi far below threshold"},
      {"threshold", "level x at which F = `at`, and psi there"},
      {"slope", "dF/dx at the threshold, not scaled by guess and lapse; of_psi: scaled, dpsi/dx"},
      {"lapse", "lapse rate with its bounds"},
      {"alpha", "of the formula"},
      {"beta", "of the formula"},
      {"pse", "level at F = 0.5; null unless guess is 0"},
      {"jnd", "guess 0: half the distance from F = 0.25 to F = 0.75; else threshold less standard"},
      {"weber_fraction", "jnd/standard; null without a standard"},
      {"log_likelihood", "with the binomial coefficients"},
      {"deviance",
       "against a proportion for each block; p by the parametric bootstrap; p_chi_squared: null for blocks of "
       "fewer than 5 trials on the average; by_level: blocks of one level taken together"},
      {"blocks", "fitted psi, deviance residual, and what changes without the block"},
      {"bootstrap", "how it was done; null where it was not; the replicates themselves in a shard"}};
}

}  // namespace

Outcome psychometric_outcome(const PsychometricRequest& request, const std::vector<Replicate>& replicates) {
  return outcome_of(request, fitted(request), replicates);
}

Outcome psychometric_outcome(const PsychometricRequest& request) {
  const Fitted one = fitted(request);
  return outcome_of(request, one, replicates_of(request, one, {0, request.replicates}));
}

Outcome psychometric_shard(const PsychometricRequest& request, base::Shard shard) {
  if (request.replicates == 0) throw std::invalid_argument("a shard of 0 replicates; ask for some");
  const Fitted one = fitted(request);
  const Share share = share_of(request.replicates, shard.k, shard.n);
  if (!one.fitter || one.fit.kind != FitKind::Found) return outcome_of(request, one, {});
  Outcome outcome = outcome_of(request, one, {});
  const std::vector<Replicate> replicates = replicates_of(request, one, share);
  outcome.json["bootstrap"] = {{"shard", fmt::format("{}/{}", shard.k, shard.n)},
                               {"first", share.first},
                               {"end", share.end},
                               {"asked", to_json(request)},
                               {"values", values_json(replicates)}};
  outcome.text = fmt::format("Shard {}/{}: {} of {} replicates; merge the JSON of all {}\n", shard.k, shard.n,
                             replicates.size(), request.replicates, counted(shard.n, "shard", "shards")) +
                 outcome.text;
  return outcome;
}

Statistic psychometric_statistic() {
  return {
      .name = "psychometric",
      .question = "How does the share of correct answers grow with the level?",
      .title = "psychometric function",
      .teaches =
          "Fits psi(x) = guess + (1 - guess - lapse) F(x) by maximum likelihood. The guess rate is fixed: "
          "1/m for m choices; 0 where the answers tell whether the comparison felt more than the standard, "
          "and then the level at F = 0.5 is the point of subjective equality. The lapse rate is fixed or "
          "free within bounds. It asks for blocks of independent answers with one function for all; the "
          "deviance tells where that is wrong. Separable answers have an infinite slope: the result says so.",
      .inputs = psychometric_inputs(),
      .data = block_data(),
      .outputs = psychometric_outputs(),
      .example = {{"data",
                   {{"level", {0, 2, 4, 6, 8, 10}},
                    {"correct", {26, 30, 38, 46, 50, 49}},
                    {"trials", {50, 50, 50, 50, 50, 50}}}},
                  {"shape", "logistic"}},
      .run = asked_psychometric};
}

}  // namespace palpate::analysis
