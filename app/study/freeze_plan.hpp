#pragma once

#include <filesystem>
#include <string>

#include "trials/protocol/protocol.hpp"

namespace palpate::app {

/// Writes the analysis plan (protocol, test, alpha, side, looks, sample, program version) into the study file
/// as an event of its hash chain, and returns the SHA-256 of its text. Makes the study where there is none.
/// Throws std::invalid_argument where a plan is frozen already, or people have answered already: a plan must
/// come first.
std::string freeze_plan(const trials::Protocol& protocol, const std::filesystem::path& study);

}  // namespace palpate::app
