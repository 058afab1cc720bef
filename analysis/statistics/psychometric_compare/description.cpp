#include "analysis/statistics/psychometric_compare/description.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "analysis/description/phrases.hpp"
#include "analysis/numerics/to_json.hpp"
#include "analysis/psychometric/compare.hpp"
#include "analysis/psychometric/measures.hpp"
#include "analysis/psychometric/request.hpp"
#include "analysis/words/words.hpp"

namespace palpate::analysis {
namespace {

using nlohmann::ordered_json;

std::vector<PsychometricCondition> conditions_of(const DataTable& table) {
  const std::vector<std::string>& names = text_column(table, "condition");
  const std::vector<Block> blocks = blocks_of(table);
  std::vector<PsychometricCondition> conditions;
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    auto found = std::ranges::find_if(conditions,
                                      [&](const PsychometricCondition& one) { return one.name == names[i]; });
    if (found == conditions.end()) found = conditions.insert(conditions.end(), {.name = names[i]});
    found->blocks.push_back(blocks[i]);
  }
  return conditions;
}

ordered_json joint_json(const JointFit& fit, const std::vector<PsychometricCondition>& conditions,
                        const PsychometricModel& model) {
  ordered_json each = ordered_json::array();
  for (std::size_t i = 0; i < fit.alpha.size(); ++i) {
    const double alpha = fit.alpha[i], beta = fit.beta[i];
    each.push_back({{"condition", conditions[i].name},
                    {"threshold", to_json(level_at(model.shape, alpha, beta, model.threshold_at))},
                    {"slope", to_json(slope_at(model.shape, alpha, beta, model.threshold_at))},
                    {"alpha", to_json(from_scale(model.shape, alpha))},
                    {"beta", to_json(beta)}});
  }
  return {{"conditions", each}, {"lapse", fit.lapse}, {"log_likelihood", to_json(fit.log_likelihood)}};
}

std::string table_of(const ordered_json& fit) {
  std::string table = fmt::format("{:>16} {:>12} {:>12}\n", "condition", "threshold", "slope");
  for (const auto& one : fit["conditions"]) {
    const auto written = [&](const char* key) {
      return one[key].is_null() ? std::string("none") : number(one[key].get<double>());
    };
    table += fmt::format("{:>16} {:>12} {:>12}\n", one["condition"].get<std::string>(), written("threshold"),
                         written("slope"));
  }
  return table;
}

std::string hypothesis_of(Same same) {
  if (same == Same::Function) return "one function holds for all conditions";
  return same == Same::Threshold ? "all conditions have the same threshold"
                                 : "all conditions have the same slope (beta)";
}

Outcome psychometric_compare_outcome(const Arguments& asked) {
  const PsychometricModel model = model_of(asked);
  const std::vector<PsychometricCondition> conditions = conditions_of(asked.table);
  const Same same = same_from_name(asked.text("same"));
  const PsychometricComparison found = compare_psychometric(conditions, model, same);
  long trials = 0;
  for (const PsychometricCondition& condition : conditions)
    for (const Block& block : condition.blocks) trials += block.trials;
  const bool answered = !found.why_not;
  const auto when_answered = [&](const ordered_json& json) {
    return answered ? json : ordered_json(nullptr);
  };
  Outcome outcome{.json = {{"procedure", "psychometric-compare"},
                           {"status", answered ? "fitted" : "not comparable"},
                           {"why", answered ? ordered_json(nullptr) : ordered_json(*found.why_not)},
                           {"same", name_of(same)},
                           {"shape", name_of(model.shape)},
                           {"n", trials},
                           {"guess", model.guess},
                           {"chi_squared", when_answered(to_json(found.chi_squared))},
                           {"degrees_of_freedom", when_answered(to_json(found.degrees_of_freedom))},
                           {"p", when_answered(to_json(found.p))},
                           {"separate", joint_json(found.separate, conditions, model)},
                           {"together", when_answered(joint_json(found.same, conditions, model))},
                           {"method", to_json(found.method)}}};
  outcome.text = fmt::format("{} with {}, {} functions, guess {}\n",
                             counted(std::ssize(conditions), "condition", "conditions"),
                             counted(trials, "answer", "answers"), name_of(model.shape),
                             model.guess == 0 ? "0" : chance_in_words(model.guess));
  if (answered) {
    outcome.text +=
        fmt::format("That {}: {} (chi-squared {} on {} of freedom, an approximation)\n", hypothesis_of(same),
                    p_in_words(found.p), number(found.chi_squared),
                    counted(static_cast<long>(found.degrees_of_freedom), "degree", "degrees")) +
        fmt::format("A function for each, lapse rate {} for all:\n", percent(found.separate.lapse)) +
        table_of(outcome.json["separate"]) +
        fmt::format("If {}, lapse rate {}:\n", hypothesis_of(same), percent(found.same.lapse)) +
        table_of(outcome.json["together"]);
  } else {
    outcome.text += fmt::format("No comparison: {}.\n", *found.why_not);
  }
  outcome.text += method_line(found.method);
  return outcome;
}

}  // namespace

Statistic psychometric_compare_statistic() {
  std::vector<Input> inputs{shape_input(),
                            guess_input(),
                            {.name = "same",
                             .kind = Input::Kind::Choice,
                             .meaning = "What the hypothesis says is the same in all conditions",
                             .usual = "function",
                             .choices = {"function", "threshold", "slope"}}};
  for (const Input& input : lapse_inputs()) inputs.push_back(input);
  inputs.push_back(threshold_at_input());
  Data data = block_data();
  data.columns.push_back({.name = "condition", .meaning = "Name of the condition"});
  return {
      .name = "psychometric-compare",
      .question = "Do conditions differ in threshold or slope?",
      .title = "comparison of psychometric functions",
      .teaches =
          "Likelihood ratio test of one function for all conditions, or of one threshold, or of one slope, "
          "against a function for each. The lapse rate is one for all conditions either way. It asks for "
          "many independent answers: its p value is that of the chi-squared distribution, which is an "
          "approximation. A condition that allows no function of its own is told, and nothing is tested.",
      .inputs = inputs,
      .data = data,
      .outputs = {{"status", "fitted or not comparable"},
                  {"why", "why there is no comparison; null where there is"},
                  {"same", "What the hypothesis says is the same"},
                  {"shape", "Form of F"},
                  {"n", "All answers"},
                  {"guess", "psi far below threshold"},
                  {"chi_squared", "Twice the difference of the log likelihoods"},
                  {"degrees_of_freedom", "Difference in the number of parameters"},
                  {"p", "p value"},
                  {"separate", "Threshold, slope, alpha, beta of each condition; lapse rate of all"},
                  {"together", "The same under the hypothesis"}},
      .example = {{"data",
                   {{"level", {0, 1, 2, 3, 4, 0, 1, 2, 3, 4}},
                    {"correct", {5, 14, 24, 40, 45, 2, 8, 20, 30, 44}},
                    {"trials", {50, 50, 50, 50, 50, 50, 50, 50, 50, 50}},
                    {"condition", {"a", "a", "a", "a", "a", "b", "b", "b", "b", "b"}}}},
                  {"guess", 0},
                  {"same", "threshold"}},
      .run = psychometric_compare_outcome};
}

}  // namespace palpate::analysis
