#pragma once

#include <fmt/format.h>

#include <filesystem>
#include <system_error>

namespace palpate::base {

/// Throws std::system_error with the message "FILE: cannot ACTION: <what the system says of `error`>".
[[noreturn]] inline void throw_cannot(int error, const char* action, const std::filesystem::path& file) {
  throw std::system_error(error, std::generic_category(),
                          fmt::format("{}: cannot {}", file.string(), action));
}

}  // namespace palpate::base
