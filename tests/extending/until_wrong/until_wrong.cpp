#include "tests/extending/until_wrong/until_wrong.hpp"

#include "trials/protocol/reading.hpp"

namespace palpate::trials {
namespace {

// The state's memory: a procedure keeps numbers and nothing else.
enum : std::size_t { kCell, kAsked };

void read(base::TomlReader& procedure, Protocol& protocol) {
  protocol.trials_per_examinee_per_cell = whole_number(procedure, "trials_per_examinee_per_cell", 1, 1000);
}

std::string order_in_words(const Protocol& protocol) {
  return fmt::format("Cell by cell: each is asked until an answer is wrong, at most {} times.",
                     protocol.trials_per_examinee_per_cell);
}

std::vector<ChosenLevel> draw_nothing(const Protocol&, Generator&) {
  return {};
}

void begin(ProcedureState& state) {
  state.memory = {0, 0};
}

std::optional<ChosenLevel> next(const ProcedureState& state, Generator&) {
  const auto cell = static_cast<std::size_t>(state.memory[kCell]);
  if (cell == state.design->cells.size()) return std::nullopt;
  return ChosenLevel{.cell = cell};
}

void tell(ProcedureState& state, const Told& told) {
  ++state.memory[kAsked];
  if (told.correct && state.memory[kAsked] < state.design->trials_per_examinee_per_cell) return;
  ++state.memory[kCell];
  state.memory[kAsked] = 0;
}

}  // namespace

constexpr Procedure kUntilWrong{.name = "until-wrong",
                                .read = read,
                                .meaning = "every cell until an answer is wrong",
                                .order_in_words = order_in_words,
                                .draw_ahead = draw_nothing,
                                .begin = begin,
                                .next = next,
                                .tell = tell};

}  // namespace palpate::trials
