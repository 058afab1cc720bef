#include "trials/procedures/constant/constant.hpp"

#include <fmt/format.h>

#include <array>

#include "base/text/toml_reader.hpp"
#include "trials/plan/random.hpp"
#include "trials/protocol/protocol.hpp"

namespace palpate::trials {
namespace {

constexpr double kMostTrials = 1000;  // of one cell in one sitting: more is a slip of the keyboard

constexpr std::array kKeys{
    base::Key{.name = "trials_per_examinee_per_cell",
              .takes = base::takes_whole(1, kMostTrials),
              .example = "8",
              .meaning = "How many trials of each cell an examinee sits."},
};

void read(base::TomlReader& procedure, Protocol& protocol) {
  protocol.trials_per_examinee_per_cell = static_cast<int>(procedure.whole("trials_per_examinee_per_cell"));
}

std::vector<ChosenLevel> draw_ahead(const Protocol& protocol, Generator& generator) {
  std::vector<ChosenLevel> levels;
  for (std::size_t cell = 0; cell < protocol.cells.size(); ++cell)
    levels.insert(levels.end(), protocol.trials_per_examinee_per_cell, {.cell = cell});
  shuffle(levels, generator);
  return levels;
}

std::string order_in_words(const Protocol& protocol) {
  return fmt::format("All {} trials of a sitting come in one random order, whatever their cell.",
                     trials_per_session(protocol));
}

std::optional<ChosenLevel> next(const ProcedureState& state, Generator&) {
  return state.told < state.ahead.size() ? std::optional(state.ahead[state.told]) : std::nullopt;
}

}  // namespace

constexpr Procedure kConstant{.name = "constant",
                              .keys = kKeys,
                              .read = read,
                              .meaning = "every level a fixed number of times",
                              .order_in_words = order_in_words,
                              .draw_ahead = draw_ahead,
                              .begin = [](ProcedureState&) {},
                              .next = next,
                              .tell = [](ProcedureState&, const Told&) {}};

}  // namespace palpate::trials
