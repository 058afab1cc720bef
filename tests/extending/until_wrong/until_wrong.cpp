#include "tests/extending/until_wrong/until_wrong.hpp"

#include <fmt/format.h>

#include <array>

#include "base/text/toml_reader.hpp"
#include "trials/protocol/protocol.hpp"

namespace palpate::trials {
namespace {

// The state's memory: a procedure keeps numbers and nothing else.
enum : std::size_t { kCell, kAsked };

constexpr std::array kKeys{
    base::Key{.name = "trials_per_examinee_per_cell",
              .takes = base::takes_whole(1, 1000),
              .example = "8",
              .meaning = "How many trials of a cell an examinee sits at most."},
};

void read(base::TomlReader& procedure, Protocol& protocol) {
  protocol.trials_per_examinee_per_cell = static_cast<int>(procedure.whole("trials_per_examinee_per_cell"));
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
                                .keys = kKeys,
                                .read = read,
                                .meaning = "every cell until an answer is wrong",
                                .order_in_words = order_in_words,
                                .draw_ahead = draw_nothing,
                                .begin = begin,
                                .next = next,
                                .tell = tell};

}  // namespace palpate::trials
