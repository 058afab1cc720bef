#pragma once

#include <algorithm>

#include "tests/trials/support/protocols.hpp"
#include "trials/procedure/procedure.hpp"

namespace palpate::trials::test {

constexpr std::size_t kUpDownTrials = 6;

/// A staircase of the tests: the level goes one cell up after a correct answer and one down after a wrong
/// one, from the first cell on, for kUpDownTrials questions. Nothing is drawn ahead.
inline constexpr Procedure kUpDown{
    .name = "up-down",
    .read = [](base::TomlReader&, Protocol&) {},
    .meaning = "one up, one down",
    .order_in_words = [](const Protocol&) { return std::string("One up, one down."); },
    .draw_ahead = [](const Protocol&, Generator&) { return std::vector<ChosenLevel>(); },
    .begin = [](ProcedureState& state) { state.memory = {0.0}; },
    .next = [](const ProcedureState& state, Generator&) -> std::optional<ChosenLevel> {
      if (state.told == kUpDownTrials) return std::nullopt;
      return ChosenLevel{.cell = static_cast<std::size_t>(state.memory[0])};
    },
    .tell =
        [](ProcedureState& state, const Told& told) {
          const double highest = static_cast<double>(state.design->cells.size() - 1);
          state.memory[0] = std::clamp(state.memory[0] + (told.correct ? 1 : -1), 0.0, highest);
        }};

/// The shipped study with its contact models as the levels of that staircase.
inline Protocol up_down_protocol() {
  Protocol protocol = small_protocol(static_cast<int>(kUpDownTrials) / 2);
  protocol.procedure = &kUpDown;
  return protocol;
}

}  // namespace palpate::trials::test
