#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "trials/protocol/protocol.hpp"

namespace palpate::app {

/// What every command takes that works on what a protocol lets feel.
struct StimulusOptions {
  std::string condition;  // empty: each
  std::string cell;       // empty: each
};

void add_stimulus(CLI::App& command, StimulusOptions& options);

/// Stimuli of the protocol in the chosen condition and cell. Throws std::invalid_argument for a name that the
/// protocol does not have.
std::vector<trials::Stimulus> chosen_stimuli(const trials::Protocol& protocol,
                                             const StimulusOptions& options);

/// The one that was chosen. Throws std::invalid_argument, with the names to choose from, for several.
/// @param wish  what needs one only: "--save"
trials::Stimulus only_stimulus(const trials::Protocol& protocol, const StimulusOptions& options,
                               std::string_view wish);

/// Throws std::invalid_argument where something was chosen though the file is a scene.
void refuse_choice(const StimulusOptions& options, const std::string& scene);

}  // namespace palpate::app
