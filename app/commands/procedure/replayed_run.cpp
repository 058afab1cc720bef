#include "app/commands/procedure/replayed_run.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "base/text/counted.hpp"

namespace palpate::app {
namespace {

constexpr std::size_t kMostAnswers = 10000;

}  // namespace

std::vector<bool> parse_answers(const std::string& text) {
  std::vector<bool> answers;
  for (std::size_t from = 0; from <= text.size();) {
    const std::size_t comma = std::min(text.find(',', from), text.size());
    const std::string answer = text.substr(from, comma - from);
    if (answer != "0" && answer != "1")
      throw std::invalid_argument(
          fmt::format("--answers: answer {} is \"{}\"; accepted: 1 (correct) and 0 (wrong), as in 1,0,1",
                      answers.size() + 1, answer));
    answers.push_back(answer == "1");
    from = comma + 1;
  }
  if (answers.size() > kMostAnswers)
    throw std::invalid_argument(
        fmt::format("--answers: found {}; accepted: at most {}", answers.size(), kMostAnswers));
  return answers;
}

ReplayedRun replay_answers(const trials::LoadedProcedure& loaded, const std::vector<bool>& answers) {
  const trials::AdaptiveProcedure& procedure = *loaded.procedure;
  const trials::AdaptiveDesign& design = *loaded.design;
  trials::AdaptiveRun run = begin_adaptive(procedure, design);
  ReplayedRun replayed;
  const auto belief = [&] {
    return procedure.belief ? std::optional(procedure.belief(design, run)) : std::nullopt;
  };
  auto before = belief();
  for (const bool correct : answers) {
    const std::optional<double> level = next_level(procedure, design, run);
    if (!level)
      throw std::invalid_argument(
          fmt::format("--answers: found {}, and the run ends after trial {}; accepted: at most {}",
                      base::counted(std::ssize(answers), "answer", "answers"), run.told, run.told));
    tell_adaptive(procedure, design, run, {.level = *level, .correct = correct});
    auto after = belief();
    replayed.trials.push_back({.level = *level,
                               .correct = correct,
                               .belief = after,
                               .expected_entropy = before ? before->expected_entropy : std::nullopt});
    before = std::move(after);
  }
  replayed.reversals = run.reversals;
  replayed.next_level = next_level(procedure, design, run);
  if (!replayed.next_level) replayed.stopped_at = run.told;
  if (procedure.mean_of_reversals) replayed.mean_of_reversals = procedure.mean_of_reversals(design, run);
  if (procedure.estimate) replayed.estimate = procedure.estimate(design, run);
  return replayed;
}

}  // namespace palpate::app
