#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace palpate::base {

/// Runs a program of the search path and waits for it, without a shell. It reads nothing, and all that it
/// prints goes into the file `output`. The signals that this program ignores are its default again.
/// @param arguments  the program's name, then its arguments
/// Returns its exit code (128 + the signal that ended it), or nothing when there is no such program. Throws
/// std::system_error when it cannot be started for another reason.
std::optional<int> run_program(std::vector<std::string> arguments, const std::filesystem::path& output);

}  // namespace palpate::base
