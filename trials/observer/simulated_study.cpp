#include "trials/observer/simulated_study.hpp"

#include <fmt/format.h>

#include "trials/observer/simulate.hpp"

namespace palpate::trials {
namespace {

constexpr int kSitting = 1;  // everybody sits once

void count(const Trial& trial, int response, bool correct, SittingCount& cell) {
  ++cell.trials;
  cell.correct_first += trial.correct_answer == 1 ? 1 : 0;
  cell.answers_first += response == 1 ? 1 : 0;
  cell.correct += correct ? 1 : 0;
}

/// Asks until the procedure has nothing left to ask, as a session does.
void sit(const Protocol& protocol, const Stimuli& stimuli, const ObserverParameters& parameters,
         const SessionRow& sitting, std::vector<SittingCount>& counts) {
  const Seed seed = sitting.facts.seed;
  Generator order = make_generator(seed, order_purpose(sitting.facts.examinee, sitting.number));
  Generator person = make_generator(seed, person_purpose(sitting.facts.examinee));
  const Observer observer = draw_observer(parameters, person);
  const std::vector<Trial> plan = draw_plan(protocol, order);
  const Procedure& procedure = *protocol.procedure;
  ProcedureState state = replay(procedure, protocol, levels_of(plan), {});
  for (int number = 1;; ++number) {
    Generator later = make_generator(seed, order_purpose(sitting.facts.examinee, sitting.number, number));
    const std::optional<ChosenLevel> level = procedure.next(state, later);
    if (!level) return;
    const bool ahead = number <= std::ssize(plan);
    const Trial trial = ahead ? plan[number - 1] : draw_trial(protocol, *level, number, later);
    const int response = play(protocol, stimuli, observer, sitting, {.trial = trial}).response;
    const bool correct = response == trial.correct_answer;
    count(trial, response, correct, counts[trial.cell]);
    state = after(procedure, std::move(state), {.level = *level, .answer = response, .correct = correct});
  }
}

}  // namespace

std::uint64_t seed_of_study(std::uint64_t seed, long study) {
  return make_generator(seed, fmt::format("study {}", study)).next();
}

std::vector<std::vector<SittingCount>> play_study(const Protocol& protocol, const Stimuli& stimuli,
                                                  const ObserverParameters& observer, std::uint64_t seed) {
  std::vector<std::vector<SittingCount>> counts(protocol.cells.size());
  for (int number = 1; number <= protocol.planned_examinees; ++number) {
    SessionRow sitting{.number = kSitting};
    sitting.facts.examinee = simulated_code(number);
    sitting.facts.seed = seed;
    std::vector<SittingCount> of_cells(protocol.cells.size());
    sit(protocol, stimuli, observer, sitting, of_cells);
    for (std::size_t cell = 0; cell < counts.size(); ++cell) counts[cell].push_back(of_cells[cell]);
  }
  return counts;
}

}  // namespace palpate::trials
