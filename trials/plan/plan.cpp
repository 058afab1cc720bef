#include "trials/plan/plan.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace palpate::trials {
namespace {

constexpr int kMostBlocks = 4;

/// A question whose content is to be drawn.
Trial numbered(const Protocol& protocol, ChosenLevel level, int number) {
  const int total = trials_per_session(protocol);
  return {.number = number, .block = 1 + (number - 1) * block_count(total) / total, .cell = level.cell};
}

}  // namespace

int block_count(int trials_per_session) {
  return std::min(kMostBlocks, trials_per_session);
}

std::vector<Trial> draw_plan(const Protocol& protocol, Generator& generator) {
  std::vector<Trial> plan;
  for (const ChosenLevel level : protocol.procedure->draw_ahead(protocol, generator))
    plan.push_back(numbered(protocol, level, static_cast<int>(plan.size()) + 1));
  protocol.task->draw(protocol, plan, generator);
  return plan;
}

Trial draw_trial(const Protocol& protocol, ChosenLevel level, int number, Generator& generator) {
  Trial trial = numbered(protocol, level, number);
  protocol.task->draw(protocol, {&trial, 1}, generator);
  return trial;
}

std::vector<ChosenLevel> levels_of(std::span<const Trial> plan) {
  std::vector<ChosenLevel> levels;
  levels.reserve(plan.size());
  for (const Trial& trial : plan) levels.push_back({.cell = trial.cell});
  return levels;
}

std::string order_purpose(std::string_view examinee, int sitting) {
  return fmt::format("order of {}, sitting {}", examinee, sitting);
}
std::string order_purpose(std::string_view examinee, int sitting, int trial) {
  return fmt::format("order of {}, sitting {}, trial {}", examinee, sitting, trial);
}

}  // namespace palpate::trials
