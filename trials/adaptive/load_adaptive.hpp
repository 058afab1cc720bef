#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "trials/adaptive/adaptive.hpp"
#include "trials/adaptive/level_reader.hpp"

namespace palpate::trials {

/// A [procedure] table as it was read.
struct LoadedProcedure {
  const AdaptiveProcedure* procedure = nullptr;
  std::unique_ptr<const AdaptiveDesign> design{};
  LevelScale scale{};   // of its levels
  std::string level{};  // the quantity of the scene that it varies; empty where the file does not say
};

/// Reads the [procedure] table of a file; what else a protocol has is not looked at.
/// Throws std::invalid_argument, "FILE:LINE: KEY: what was found, what is accepted".
LoadedProcedure load_adaptive(const std::filesystem::path& file);
/// The same of a text. @param file  its name in messages
LoadedProcedure parse_adaptive(std::string_view text, const std::string& file);

}  // namespace palpate::trials
