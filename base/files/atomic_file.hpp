#pragma once

#include <sys/types.h>

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace palpate::base {

/// Writes a file aside (same folder), flushes it to the disk, then renames it over `file`: a reader sees the
/// old file or the whole new one. Throws std::system_error that names the file when the disk refuses; nothing
/// is left behind.
/// @param mode  who may read and write it
void write_atomically(const std::filesystem::path& file, std::string_view bytes, ::mode_t mode = 0644);

struct FileText {
  std::filesystem::path file{};
  std::string text{};
};

/// Writes several files likewise, all aside before the first one takes its place: where the disk refuses one of them,
/// none has changed.
void write_together(std::span<const FileText> files, ::mode_t mode = 0644);

}  // namespace palpate::base
