#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace palpate::app {

/// Adds `--format text|json` to a command that prints a result.
inline void add_format(CLI::App& command, std::string& format) {
  command.add_option("--format", format, "What to print the result as")
      ->check(CLI::IsMember({"text", "json"}))
      ->default_val("text");
}

}  // namespace palpate::app
