#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "trials/plan/random.hpp"
#include "trials/protocol/protocol.hpp"

namespace palpate::trials {

/// One question as drawn.
struct Trial {
  int number = 0;                                 // from 1, within the sitting
  int block = 0;                                  // from 1: part of the sitting, a column of exports
  std::size_t cell = 0;                           // into Protocol::cells
  std::vector<std::size_t> interval_condition{};  // into Protocol::conditions, one for each interval
  int correct_answer = 0;                         // from 1: a choice of the task

  bool operator==(const Trial&) const = default;
};

/// The questions of one sitting that are asked whatever is answered: the levels as the procedure draws them
/// ahead, then the content of each as the task draws it. To be stored trial by trial, never derived again.
std::vector<Trial> draw_plan(const Protocol& protocol, Generator& generator);

/// The levels of a plan, as a procedure is told that they were drawn ahead.
std::vector<ChosenLevel> levels_of(std::span<const Trial> plan);

/// One question at a level that the procedure chose after answers.
Trial draw_trial(const Protocol& protocol, ChosenLevel level, int number, Generator& generator);

/// What the order of a sitting is drawn for: the purpose of its generator; and that of a trial which is drawn
/// after answers.
std::string order_purpose(std::string_view examinee, int sitting);
std::string order_purpose(std::string_view examinee, int sitting, int trial);

/// How many blocks a sitting is told in: at most 4, of equal length to within one trial.
int block_count(int trials_per_session);

}  // namespace palpate::trials
