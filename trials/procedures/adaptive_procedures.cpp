#include <array>

#include "trials/adaptive/adaptive.hpp"
#include "trials/procedures/pest/pest.hpp"
#include "trials/procedures/psi/psi.hpp"
#include "trials/procedures/quest/quest.hpp"
#include "trials/procedures/questplus/questplus.hpp"
#include "trials/procedures/staircase/staircase.hpp"
#include "trials/procedures/weighted/weighted.hpp"

namespace palpate::trials {

std::span<const AdaptiveProcedure* const> adaptive_procedures() {
  static constexpr std::array kProcedures{
      &kStaircase, &kWeighted, &kQuestPlus, &kQuest, &kPsi, &kPest,
  };
  return kProcedures;
}

}  // namespace palpate::trials
