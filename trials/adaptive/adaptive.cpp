#include "trials/adaptive/adaptive.hpp"

namespace palpate::trials {

bool has_stopped(const StopRule& stop, const AdaptiveRun& run) {
  return (stop.reversals && std::ssize(run.reversals) >= *stop.reversals) ||
         (stop.trials && run.told >= *stop.trials);
}

std::optional<double> next_level(const AdaptiveProcedure& procedure, const AdaptiveDesign& design,
                                 const AdaptiveRun& run) {
  if (has_stopped(design.stop, run)) return std::nullopt;
  return procedure.next(design, run);
}

AdaptiveRun begin_adaptive(const AdaptiveProcedure& procedure, const AdaptiveDesign& design) {
  AdaptiveRun run;
  procedure.begin(design, run);
  return run;
}

void tell_adaptive(const AdaptiveProcedure& procedure, const AdaptiveDesign& design, AdaptiveRun& run,
                   const AdaptiveAnswer& answer) {
  procedure.tell(design, run, answer);
  ++run.told;
}

AdaptiveRun replay_adaptive(const AdaptiveProcedure& procedure, const AdaptiveDesign& design,
                            std::span<const AdaptiveAnswer> answers) {
  AdaptiveRun run = begin_adaptive(procedure, design);
  for (const AdaptiveAnswer& answer : answers) tell_adaptive(procedure, design, run, answer);
  return run;
}

}  // namespace palpate::trials
