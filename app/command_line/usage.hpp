#pragma once

#include <CLI/CLI.hpp>
#include <span>
#include <string>

namespace palpate::app {

/// What is wrong with the arguments, what was perhaps meant, and where help is.
std::string usage_error(const CLI::App* app, const CLI::Error& error);

/// Throws CLI::ValidationError for an empty value, as an empty shell variable leaves it: `--study ""`, and
/// `--study=`, for which the library would take the argument that follows.
void refuse_empty(std::span<char* const> arguments);

}  // namespace palpate::app
