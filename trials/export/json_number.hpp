#pragma once

#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>

namespace palpate::trials {

/// A bound of a codebook: 1 rather than 1.0.
inline nlohmann::ordered_json json_number(double value) {
  if (value == std::floor(value) && std::abs(value) < 1e15) return static_cast<std::int64_t>(value);
  return value;
}

}  // namespace palpate::trials
