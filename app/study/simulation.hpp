#pragma once

#include <filesystem>
#include <string>

#include "trials/observer/simulate.hpp"

namespace palpate::app {

/// The observer that is simulated where none is named: protocols/observers/default.toml beside the program's
/// source, or $PALPATE_DATA/protocols/observers/default.toml.
std::filesystem::path default_observer();

struct SimulationResult {
  trials::SimulationReport report{};
  trials::Receipt receipt{};
};

/// Validates everything, then runs simulated examinees into the study file, with a progress bar. Words about
/// the work go to stderr. Throws Interrupted after Ctrl-C, when all that was answered is on the disk.
SimulationResult run_simulation(const std::filesystem::path& protocol, const std::filesystem::path& study,
                                int examinees, const std::filesystem::path& observer, trials::Seed seed);

}  // namespace palpate::app
