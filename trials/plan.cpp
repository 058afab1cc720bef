#include "trials/plan.hpp"

#include <algorithm>
#include <cassert>
#include <utility>

namespace palpate::trials {
namespace {

constexpr int kMostBlocks = 4;

/// A fair coin decides which of the pair comes first.
void flip(const Protocol& protocol, Trial& trial, Generator& generator) {
  const auto [first, second] = protocol.pair;
  const bool swapped = generator.coin();
  trial.interval_condition = {swapped ? second : first, swapped ? first : second};
  trial.correct_interval = trial.interval_condition[0] == protocol.correct ? 1 : 2;
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
  for (std::size_t last = plan.size(); last > 1; --last)  // Fisher-Yates
    std::swap(plan[last - 1], plan[generator.below(last)]);

  const int total = static_cast<int>(plan.size());
  for (int i = 0; i < total; ++i) {
    Trial& trial = plan[static_cast<std::size_t>(i)];
    trial.number = i + 1;
    trial.block = 1 + i * block_count(total) / total;
    flip(protocol, trial, generator);
  }
  return plan;
}

Trial redraw(const Protocol& protocol, Trial trial, Generator& generator) {
  flip(protocol, trial, generator);
  return trial;
}

}  // namespace palpate::trials
