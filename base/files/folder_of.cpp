#include "base/files/folder_of.hpp"

#include <fmt/format.h>

#include <stdexcept>
#include <system_error>

namespace palpate::base {

void require_folder_of(const std::filesystem::path& file) {
  const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : ".";
  std::error_code none;
  if (std::filesystem::is_directory(folder, none)) return;
  throw std::invalid_argument(
      fmt::format("{}: cannot be written: {} {}; accepted: a file in a folder that is there", file.string(),
                  folder.string(), std::filesystem::exists(folder, none) ? "is no folder" : "is not there"));
}

}  // namespace palpate::base
