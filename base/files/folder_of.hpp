#pragma once

#include <filesystem>

namespace palpate::base {

/// Throws std::invalid_argument unless the folder that `file` is to be written into exists.
void require_folder_of(const std::filesystem::path& file);

}  // namespace palpate::base
