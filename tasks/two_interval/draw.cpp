#include <algorithm>

#include "tasks/two_interval/two_interval.hpp"

namespace palpate::tasks::two_interval {

using trials::Generator;
using trials::IntervalOrder;
using trials::Protocol;
using trials::Trial;

namespace {

void set_order(const Protocol& protocol, Trial& trial, bool swapped) {
  const std::size_t first = protocol.presented[0], second = protocol.presented[1];
  trial.interval_condition = {swapped ? second : first, swapped ? first : second};
  trial.correct_answer = correct_answer(protocol, trial);
}

/// For each cell, half of its trials in either order, in a random sequence; to be dealt out from the back.
std::vector<std::vector<char>> balanced_orders(const Protocol& protocol, std::span<const Trial> trials,
                                               Generator& generator) {
  std::vector<std::vector<char>> swapped(protocol.cells.size());
  for (const Trial& trial : trials) swapped[trial.cell].push_back(0);
  for (std::vector<char>& cell : swapped) {
    std::fill_n(cell.begin(), cell.size() / 2, 1);
    trials::shuffle(cell, generator);
  }
  return swapped;
}

}  // namespace

void draw(const Protocol& protocol, std::span<Trial> trials, Generator& generator) {
  if (protocol.interval_order == IntervalOrder::Coin) {
    for (Trial& trial : trials) set_order(protocol, trial, generator.coin());
    return;
  }
  auto orders = balanced_orders(protocol, trials, generator);
  for (Trial& trial : trials) {
    set_order(protocol, trial, orders[trial.cell].back() != 0);
    orders[trial.cell].pop_back();
  }
}

/// A balanced order is kept, since a new draw of one trial would unbalance it.
void redraw(const Protocol& protocol, Trial& trial, Generator& generator) {
  if (protocol.interval_order == IntervalOrder::Coin) set_order(protocol, trial, generator.coin());
}

int correct_answer(const Protocol& protocol, const Trial& trial) {
  const auto held = std::ranges::find(trial.interval_condition, protocol.correct);
  return held == trial.interval_condition.end()
             ? 0
             : 1 + static_cast<int>(held - trial.interval_condition.begin());
}

}  // namespace palpate::tasks::two_interval
