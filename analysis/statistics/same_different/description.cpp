#include "analysis/statistics/same_different/description.hpp"

#include <fmt/core.h>

#include "analysis/description/phrases.hpp"
#include "analysis/detection/count_pair.hpp"
#include "analysis/detection/detection.hpp"
#include "analysis/detection/detection_words.hpp"
#include "analysis/numerics/to_json.hpp"
#include "analysis/words/words.hpp"

namespace palpate::analysis {
namespace {

Outcome same_different_outcome(const Arguments& asked) {
  const auto [hits, different] = count_pair(asked, "different");
  const auto [false_alarms, same] = count_pair(asked, "same");
  const Strategy strategy = strategy_from_name(asked.text("strategy"));
  const Detection result = same_different(
      {.hits = hits, .signal_trials = different, .false_alarms = false_alarms, .noise_trials = same},
      strategy, correction_from_name(asked.text("correction")), asked.level());
  Outcome outcome{.json = {{"procedure", "same-different"}, {"strategy", name_of(strategy)}}};
  put_detection(outcome.json, result);
  outcome.json["criterion"] = to_json(result.criterion);
  outcome.json["method"] = to_json(result.method);
  const std::string criterion =
      strategy == Strategy::Differencing
          ? fmt::format("Criterion: \"different\" from a distance of {} on\n", number(result.criterion))
          : fmt::format("Criterion c = {} (below 0: \"different\" is favoured)\n", number(result.criterion));
  const std::string none =
      result.d_prime > 0 ? "" : "\"Different\" came no more often to pairs that differed: d' is 0.\n";
  outcome.text = detection_in_words(result, "\"Different\" to pairs that differed",
                                    "\"Different\" to pairs that were the same") +
                 none + criterion + method_line(result.method);
  return outcome;
}

}  // namespace

Statistic same_different_statistic() {
  std::vector<Output> outputs = detection_outputs();
  outputs.insert(outputs.begin(), {"strategy", "How an answer is taken to come about"});
  outputs.push_back({"criterion",
                     "differencing: smallest distance called different; else c, below 0 where "
                     "\"different\" is favoured"});
  return {
      .name = "same-different",
      .question = "How well are pairs that differ told from pairs that are the same?",
      .title = "d' of a same-different task",
      .teaches =
          "d' depends on how an answer comes about, so the strategy has to be said. Differencing: the two "
          "observations lie far enough apart; the choice where stimuli vary from trial to trial. Independent "
          "observations: each is judged for itself; the better strategy, open to those who know two fixed "
          "stimuli. Off a neutral criterion the latter takes the ROC for normal, as the tables of "
          "Macmillan & Creelman do. The same answers mean a larger d' under differencing.",
      .inputs = {count_pair_input("different", "answers \"different\"", "pairs that differed"),
                 count_pair_input("same", "answers \"different\"", "pairs that were the same"),
                 {.name = "strategy",
                  .kind = Input::Kind::Choice,
                  .meaning = "How an answer is taken to come about",
                  .choices = {"differencing", "independent-observations"}},
                 correction_input("log-linear"),
                 level_input()},
      .outputs = outputs,
      .example = {{"different", {24, 30}}, {"same", {9, 30}}, {"strategy", "differencing"}},
      .run = same_different_outcome};
}

}  // namespace palpate::analysis
