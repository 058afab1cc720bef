#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/text/key.hpp"

namespace palpate::base {
class TomlReader;
}

namespace palpate::trials {

class Generator;
struct Protocol;

/// What a procedure chooses for a question.
struct ChosenLevel {
  std::size_t cell = 0;  // into Protocol::cells

  bool operator==(const ChosenLevel&) const = default;
};

/// A question that was answered, as a procedure hears of it.
struct Told {
  ChosenLevel level{};
  int answer = 0;  // from 1
  bool correct = false;
};

/// Where a procedure stands in one sitting. Never stored: replay() makes it anew from what is.
struct ProcedureState {
  const Protocol* design = nullptr;
  std::vector<ChosenLevel> ahead{};  // drawn before the first answer, in the order of asking
  std::size_t told = 0;              // answers heard of
  std::vector<double> memory{};      // what the procedure keeps of them: a staircase its level and its run
};

/// How levels are chosen. The state follows from the levels drawn ahead and the answers alone, so that a
/// sitting is taken up again, and verified, by replaying what its study file holds; what next() draws by
/// chance is stored with its question, before that is shown.
struct Procedure {
  std::string_view name;  // "constant": procedure.kind in a protocol, and a column

  /// Of [procedure], apart from kind.
  std::span<const base::Key> keys{};
  /// [procedure], all but kind. What is refused throws std::invalid_argument.
  void (*read)(base::TomlReader& procedure, Protocol& protocol);
  std::string_view meaning;  // in codebook and reference: how levels are chosen
  std::string (*order_in_words)(const Protocol& protocol);  // in which the cells are asked, a sentence

  /// The levels that are asked whatever is answered, in order; may be none. Which they are, and how often each,
  /// follows from the protocol; only their order may be drawn.
  std::vector<ChosenLevel> (*draw_ahead)(const Protocol& protocol, Generator& generator);
  /// Before the first answer. Sets memory; design and ahead are given.
  void (*begin)(ProcedureState& state);
  /// The level of the next question; nothing when the sitting is complete.
  std::optional<ChosenLevel> (*next)(const ProcedureState& state, Generator& generator);
  /// Hears of the answer to the question that came next. Changes memory only.
  void (*tell)(ProcedureState& state, const Told& told);
};

/// Every procedure that there is. The list stands in trials/procedures/procedures.cpp, above the protocol,
/// which names one.
std::span<const Procedure* const> procedures();

/// The state after these answers, in the order in which they were given.
ProcedureState replay(const Procedure& procedure, const Protocol& design, std::vector<ChosenLevel> ahead,
                      std::span<const Told> answers);

/// One answer more.
ProcedureState after(const Procedure& procedure, ProcedureState state, const Told& told);

}  // namespace palpate::trials
