#include <array>

#include "tasks/two_interval/two_interval.hpp"

namespace palpate::trials {

std::span<const Task* const> tasks() {
  static constexpr std::array kTasks{
      &palpate::tasks::kTwoInterval,
  };
  return kTasks;
}

}  // namespace palpate::trials
