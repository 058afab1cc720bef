#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace palpate::base {

/// A file, byte for byte. Throws std::invalid_argument for one that is missing, a folder, a device or
/// unreadable, and std::system_error where the disk fails while it is read. Reads from a pipe as well.
/// @param accepted  what is expected there, for the message: "a mesh file"; empty: any file
std::string read_file(const std::filesystem::path& file, std::string_view accepted = {});

}  // namespace palpate::base
