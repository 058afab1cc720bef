#pragma once

#include <filesystem>

namespace palpate::app {

/// The folder that holds `data` and `protocols`: what PALPATE_DATA says, else the root of the source.
std::filesystem::path data_folder();

}  // namespace palpate::app
