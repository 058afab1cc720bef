#include "analysis/statistics/yes_no/description.hpp"

#include <fmt/core.h>

#include "analysis/description/phrases.hpp"
#include "analysis/detection/count_pair.hpp"
#include "analysis/detection/detection.hpp"
#include "analysis/detection/detection_words.hpp"
#include "analysis/numerics/to_json.hpp"
#include "analysis/words/words.hpp"

namespace palpate::analysis {
namespace {

std::string criterion_in_words(const Detection& result) {
  const double c = result.criterion;
  const std::string favoured = c < 0 ? "\"yes\" is favoured" : c > 0 ? "\"no\" is favoured" : "neutral";
  return fmt::format("Criterion c = {} (standard error {}): {}. ln beta = {}\n", number(c),
                     number(result.standard_error / 2), favoured, number(c * result.d_prime));
}

Outcome yes_no_outcome(const Arguments& asked) {
  const auto [hits, signal_trials] = count_pair(asked, "signal");
  const auto [false_alarms, noise_trials] = count_pair(asked, "noise");
  const Detection result = yes_no({.hits = hits,
                                   .signal_trials = signal_trials,
                                   .false_alarms = false_alarms,
                                   .noise_trials = noise_trials},
                                  correction_from_name(asked.text("correction")), asked.level());
  Outcome outcome{.json = {{"procedure", "yes-no"}}};
  put_detection(outcome.json, result);
  outcome.json["criterion"] = to_json(result.criterion);
  outcome.json["criterion_standard_error"] = to_json(result.standard_error / 2);
  outcome.json["log_beta"] = to_json(result.criterion * result.d_prime);
  outcome.json["method"] = to_json(result.method);
  outcome.text = detection_in_words(result, "\"Yes\" to the signal", "\"Yes\" without it") +
                 criterion_in_words(result) + method_line(result.method);
  return outcome;
}

}  // namespace

Statistic yes_no_statistic() {
  std::vector<Output> outputs = detection_outputs();
  outputs.push_back({"criterion", "c: below 0 where \"yes\" is favoured; null where it is infinite"});
  outputs.push_back({"criterion_standard_error", "half that of d'"});
  outputs.push_back({"log_beta", "ln of the likelihood ratio at the criterion, c d'"});
  return {
      .name = "yes-no",
      .question = "How well is a signal told from its absence, and which answer is favoured?",
      .title = "d' and criterion of a yes/no task",
      .teaches =
          "One stimulus a trial, with or without the signal. The share of \"yes\" in both kinds of trials "
          "parts what is felt, d' = z(hits) - z(false alarms), from what is preferred, c = -(z(hits) + "
          "z(false alarms))/2. It takes both kinds for equally variable. The log-linear correction adds "
          "half an answer to both sides of every rate (Hautus 1995); the interval is taken from the counts "
          "as they are.",
      .inputs = {count_pair_input("signal", "hits", "trials with the signal"),
                 count_pair_input("noise", "false alarms", "trials without"), correction_input("log-linear"),
                 level_input()},
      .outputs = outputs,
      .example = {{"signal", {20, 30}}, {"noise", {8, 30}}},
      .run = yes_no_outcome};
}

}  // namespace palpate::analysis
