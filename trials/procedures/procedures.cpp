#include <array>

#include "trials/procedure/procedure.hpp"
#include "trials/procedures/constant/constant.hpp"

namespace palpate::trials {

std::span<const Procedure* const> procedures() {
  static constexpr std::array kProcedures{
      &kConstant,
  };
  return kProcedures;
}

}  // namespace palpate::trials
