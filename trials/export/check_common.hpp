#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace palpate::trials {

using Problems = std::vector<std::string>;

/// The text of a file; a problem, and empty, when it cannot be read.
std::string read_text(const std::filesystem::path& root, const std::filesystem::path& file,
                      Problems& problems);

/// A JSON object: UTF-8 without byte-order mark, no key twice. A problem, and an empty object, when it is
/// none.
nlohmann::json read_object(const std::filesystem::path& root, const std::filesystem::path& file,
                           Problems& problems);

/// A non-empty text under `key`; a problem when there is none.
std::string required_text(const nlohmann::json& object, const char* key, std::string_view where,
                          Problems& problems);

/// Every file below `root`, relative to it, sorted.
std::vector<std::filesystem::path> files_below(const std::filesystem::path& root);

}  // namespace palpate::trials
