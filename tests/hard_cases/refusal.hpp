#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

namespace palpate::hard_cases {

/// What some work was refused with (std::invalid_argument); "" where it was not.
template <class Work>
std::string refused(Work work) {
  try {
    work();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

inline bool says(const std::string& message, std::string_view words) {
  return message.find(words) != std::string::npos;
}

}  // namespace palpate::hard_cases
