#include "trials/procedure/procedure.hpp"

#include <utility>

namespace palpate::trials {

ProcedureState after(const Procedure& procedure, ProcedureState state, const Told& told) {
  procedure.tell(state, told);
  ++state.told;
  return state;
}

ProcedureState replay(const Procedure& procedure, const Protocol& design, std::vector<ChosenLevel> ahead,
                      std::span<const Told> answers) {
  ProcedureState state{.design = &design, .ahead = std::move(ahead)};
  procedure.begin(state);
  for (const Told& told : answers) state = after(procedure, std::move(state), told);
  return state;
}

}  // namespace palpate::trials
