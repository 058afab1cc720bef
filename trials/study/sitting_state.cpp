#include "trials/study/sitting_state.hpp"

#include <algorithm>
#include <iterator>
#include <set>

namespace palpate::trials {

Told told_of(const DrawnTrial& drawn, const AnswerRow& answer) {
  return {.level = {.cell = drawn.trial.cell}, .answer = answer.response, .correct = answer.correct};
}

std::vector<DrawnTrial> drawn_ahead(std::span<const DrawnTrial> trials, std::span<const EventRow> events) {
  if (trials.empty()) return {};
  std::set<int> later;
  for (const EventRow& event : events)
    if (event.session == trials.front().session && event.kind == event_kind::kDrawn && event.trial)
      later.insert(*event.trial);
  std::vector<DrawnTrial> ahead;
  std::ranges::copy_if(trials, std::back_inserter(ahead), [&](const DrawnTrial& drawn) {
    return drawn.draw == 0 && !later.contains(drawn.trial.number);
  });
  return ahead;
}

std::vector<Told> told_by(const SittingRows& sitting) {
  std::vector<Told> told;
  for (const AnswerRow& answer : sitting.answers) {
    const auto drawn = std::ranges::find_if(sitting.trials, [&](const DrawnTrial& trial) {
      return trial.trial.number == answer.trial && trial.draw == answer.draw;
    });
    if (drawn != sitting.trials.end()) told.push_back(told_of(*drawn, answer));
  }
  return told;
}

std::vector<ChosenLevel> levels_of(std::span<const DrawnTrial> ahead) {
  std::vector<ChosenLevel> levels;
  std::ranges::transform(ahead, std::back_inserter(levels),
                         [](const DrawnTrial& drawn) { return ChosenLevel{.cell = drawn.trial.cell}; });
  return levels;
}

}  // namespace palpate::trials
