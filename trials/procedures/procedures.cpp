#include <array>

#include "trials/procedure/procedure.hpp"
#include "trials/procedures/constant/constant.hpp"

namespace palpate::trials {

std::span<const Procedure* const> procedures() {
  static constexpr std::array<const Procedure*, 1> kProcedures{
      &kConstant,
  };
  return kProcedures;
}

}  // namespace palpate::trials
