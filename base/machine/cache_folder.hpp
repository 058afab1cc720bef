#pragma once

#include <filesystem>

namespace palpate::base {

/// Where this program keeps what it can make anew: $PALPATE_CACHE, else $XDG_CACHE_HOME/palpate, else
/// ~/.cache/palpate; empty where there is no such place.
std::filesystem::path cache_folder();

}  // namespace palpate::base
