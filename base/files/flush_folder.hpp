#pragma once

#include <filesystem>

namespace palpate::base {

/// Puts the name of a file that was just made or renamed on the disk. Where the folder cannot be opened, or
/// its file system knows no such thing, nothing is done.
void flush_folder(const std::filesystem::path& file);

}  // namespace palpate::base
