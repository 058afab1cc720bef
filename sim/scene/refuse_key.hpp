#pragma once

#include <fmt/format.h>

#include <stdexcept>
#include <string>

namespace palpate::sim {

/// Throws std::invalid_argument "KEY: WHAT", as for a key of a scene file whose value cannot be used.
[[noreturn]] inline void refuse_key(const std::string& key, const std::string& what) {
  throw std::invalid_argument(fmt::format("{}: {}", key, what));
}

}  // namespace palpate::sim
