#pragma once

#include <fmt/format.h>

#include <string>
#include <string_view>

namespace palpate::base {

/// "1 answer", "2 answers".
inline std::string counted(long count, std::string_view singular, std::string_view plural) {
  return fmt::format("{} {}", count, count == 1 ? singular : plural);
}

}  // namespace palpate::base
