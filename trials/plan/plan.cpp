#include "trials/plan/plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <utility>

namespace palpate::trials {
namespace {

constexpr int kMostBlocks = 4;

void set_order(const Protocol& protocol, Trial& trial, bool swapped) {
  const auto [first, second] = protocol.pair;
  trial.interval_condition = {swapped ? second : first, swapped ? first : second};
  trial.correct_interval = trial.interval_condition[0] == protocol.correct ? 1 : 2;
}

/// Fisher-Yates: every order is as likely as any other.
template <typename Item>
void shuffle(std::vector<Item>& items, Generator& generator) {
  for (std::size_t last = items.size(); last > 1; --last) {
    const std::size_t other = generator.below(last);
    std::swap(items[last - 1], items[other]);
  }
}

/// For each cell, half of its trials in either order, in a random sequence; to be dealt out from the back.
std::vector<std::vector<char>> balanced_orders(const Protocol& protocol, Generator& generator) {
  const auto trials = static_cast<std::size_t>(protocol.trials_per_examinee_per_cell);
  std::vector<std::vector<char>> swapped(protocol.cells.size(), std::vector<char>(trials, 0));
  for (std::vector<char>& cell : swapped) {
    std::fill_n(cell.begin(), trials / 2, 1);
    shuffle(cell, generator);
  }
  return swapped;
}

}  // namespace

int block_count(int trials_per_session) {
  return std::min(kMostBlocks, trials_per_session);
}

std::vector<Trial> draw_plan(const Protocol& protocol, Generator& generator) {
  std::vector<Trial> plan;
  for (std::size_t cell = 0; cell < protocol.cells.size(); ++cell)
    for (int i = 0; i < protocol.trials_per_examinee_per_cell; ++i) {
      plan.emplace_back();
      plan.back().cell = cell;
    }
  shuffle(plan, generator);

  const bool balanced = protocol.interval_order == "balanced";
  auto orders = balanced ? balanced_orders(protocol, generator) : std::vector<std::vector<char>>{};
  const int total = static_cast<int>(plan.size());
  for (int i = 0; i < total; ++i) {
    Trial& trial = plan[i];
    trial.number = i + 1;
    trial.block = 1 + i * block_count(total) / total;
    if (balanced) {
      set_order(protocol, trial, orders[trial.cell].back() != 0);
      orders[trial.cell].pop_back();
    } else {
      set_order(protocol, trial, generator.coin());
    }
  }
  return plan;
}

std::string order_purpose(std::string_view examinee, int sitting) {
  return fmt::format("order of {}, sitting {}", examinee, sitting);
}

Trial redraw(const Protocol& protocol, Trial trial, Generator& generator) {
  if (protocol.interval_order == "coin") set_order(protocol, trial, generator.coin());
  return trial;
}

}  // namespace palpate::trials
