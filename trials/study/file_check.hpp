#pragma once

#include <filesystem>

namespace palpate::trials {

/// Looks at a file's first bytes, without SQLite: throws std::invalid_argument unless it is a study file of a
/// version that this program knows, and not cut short.
void check_is_study_file(const std::filesystem::path& file);

/// Throws unless a study can be written at `file`: its folder is there (std::invalid_argument), can be
/// written (std::runtime_error) and is not on a network drive, where SQLite's locks do not hold
/// (std::invalid_argument).
void check_writable(const std::filesystem::path& file);

}  // namespace palpate::trials
