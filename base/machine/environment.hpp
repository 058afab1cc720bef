#pragma once

#include <cstdlib>
#include <optional>
#include <string>

namespace palpate::base {

/// What an environment variable holds; nothing where it is not set or empty.
inline std::optional<std::string> environment(const char* variable) {
  const char* value = std::getenv(variable);  // NOLINT(concurrency-mt-unsafe): nothing here sets a variable
  return value == nullptr || *value == '\0' ? std::nullopt : std::optional<std::string>(value);
}

}  // namespace palpate::base
