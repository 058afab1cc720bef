#pragma once

#include <limits>

namespace palpate::analysis {

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

}  // namespace palpate::analysis
