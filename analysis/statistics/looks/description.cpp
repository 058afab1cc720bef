#include "analysis/statistics/looks/description.hpp"

#include <fmt/core.h>

#include <stdexcept>

#include "analysis/binomial/to_json.hpp"
#include "analysis/description/phrases.hpp"
#include "analysis/numerics/to_json.hpp"
#include "analysis/statistics/looks/planned_looks.hpp"
#include "analysis/words/words.hpp"

namespace palpate::analysis {
namespace {

constexpr long kMostAtALook = 100'000;  // the time grows with their square: some seconds

std::string region(const CriticalNumber& critical) {
  if (critical.at_least) return fmt::format("{} or more correct reject", *critical.at_least);
  if (critical.at_most) return fmt::format("{} or fewer correct reject", *critical.at_most);
  return "no number rejects";
}

Outcome looks_outcome(const Arguments& asked) {
  const std::vector<long> trials = asked.counts("trials");
  for (const long n : trials) {
    if (n <= kMostAtALook) continue;
    throw std::invalid_argument(fmt::format(
        "a look after {} answers; accepted: up to {}, for every number of correct answers is counted", n,
        kMostAtALook));
  }
  const auto looks = planned_looks(trials, asked.number("chance"), asked.number("alpha"), asked.side(),
                                   spending_from_name(asked.text("spending")));
  Outcome outcome;
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  for (const PlannedLook& look : looks) {
    rows.push_back(
        {{"trials", look.critical.trials},
         {"alpha_spent", look.critical.alpha},
         {"at_least", look.critical.at_least ? nlohmann::ordered_json(*look.critical.at_least) : nullptr},
         {"at_most", look.critical.at_most ? nlohmann::ordered_json(*look.critical.at_most) : nullptr},
         {"rejected_by_now", look.size}});
    outcome.text += fmt::format("{}: {} (alpha spent {}; guessers rejected by now {})\n",
                                counted(look.critical.trials, "answer", "answers"), region(look.critical),
                                number(look.critical.alpha), number(look.size));
  }
  outcome.text += method_line(looks.back().critical.method);
  outcome.json = {{"procedure", "looks"},
                  {"looks", rows},
                  {"size", looks.back().size},
                  {"method", to_json(looks.back().critical.method)}};
  return outcome;
}

}  // namespace

Statistic looks_statistic() {
  return {
      .name = "looks",
      .question = "How many correct answers are needed when there are looks on the way?",
      .title = "exact binomial test at planned looks",
      .teaches =
          "Whoever looks at the answers several times and stops when they are significant rejects guessing "
          "too often. With looks planned beforehand, alpha is spent over them: obrien-fleming hardly "
          "anything early, pocock evenly. Exact binomial probabilities; alpha that whole numbers leave "
          "unspent is carried on. One-sided.",
      .inputs = {{.name = "trials",
                  .kind = Input::Kind::Counts,
                  .meaning = fmt::format("Answers that are in at each look, up to {}", kMostAtALook)},
                 chance_input(),
                 alpha_input(),
                 {.name = "side",
                  .kind = Input::Kind::Choice,
                  .meaning = "Alternative, decided beforehand",
                  .usual = "greater",
                  .choices = {"greater", "less"}},
                 {.name = "spending",
                  .kind = Input::Kind::Choice,
                  .meaning = "How alpha is spent",
                  .usual = "obrien-fleming",
                  .choices = {"obrien-fleming", "pocock"}}},
      .outputs = {{"looks",
                   "For each: trials, alpha_spent, at_least or at_most, rejected_by_now under guessing"},
                  {"size", "Probability that guessing is rejected at any look"}},
      .example = {{"trials", {40, 80, 120}}, {"alpha", 0.05}, {"spending", "obrien-fleming"}},
      .run = looks_outcome};
}

}  // namespace palpate::analysis
