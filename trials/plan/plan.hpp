#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "trials/plan/random.hpp"
#include "trials/protocol/protocol.hpp"

namespace palpate::trials {

/// One question as drawn.
struct Trial {
  int number = 0;                                 // from 1, within the sitting
  int block = 0;                                  // from 1: what progress is shown by
  std::size_t cell = 0;                           // into Protocol::cells
  std::vector<std::size_t> interval_condition{};  // into Protocol::conditions, one for each interval
  int correct_interval = 0;                       // from 1

  bool operator==(const Trial&) const = default;
};

/// The order of one sitting: every cell trials_per_examinee_per_cell times in one random order
/// (Fisher-Yates), and for each trial which interval comes first: a fair coin, or, where the protocol
/// balances, either order in half of each cell's trials, in random sequence. To be stored trial by trial,
/// never derived again.
std::vector<Trial> draw_plan(const Protocol& protocol, Generator& generator);

/// What the order of a sitting is drawn for: the purpose of its generator.
std::string order_purpose(std::string_view examinee, int sitting);

/// Draws the order of intervals of an interrupted trial again; its cell stays. A balanced order is kept,
/// since a new draw of one trial would unbalance it.
Trial redraw(const Protocol& protocol, Trial trial, Generator& generator);

/// How many blocks progress is shown by: at most 4, of equal length to within one trial.
int block_count(int trials_per_session);

}  // namespace palpate::trials
