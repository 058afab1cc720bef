#pragma once

#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cstdint>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>

namespace palpate::app {

/// Adds `--format text|json` to a command that prints a result.
inline void add_format(CLI::App& command, std::string& format) {
  command.add_option("--format", format, "What to print the result as")
      ->check(CLI::IsMember({"text", "json"}))
      ->default_val("text");
}

/// Adds `--full` to a command whose result is longer than a screen.
inline void add_full(CLI::App& command, bool& full) {
  command.add_flag("--full", full,
                   "Print everything on a terminal too, not a screenful (a pipe gets all of it)");
}

/// Whether a screenful is enough: standard output is a terminal, and nobody asked for all.
inline bool brief(bool full) {
  return !full && ::isatty(STDOUT_FILENO) == 1;
}

/// Columns of the terminal that standard output is, at most 100; 100 where it does not tell.
std::size_t terminal_width();

/// Adds `--seed` to a command that draws. CLI11 alone takes -1 and all that is too large for 2^64 - 1.
CLI::Option* add_seed(CLI::App& command, const std::string& meaning,
                      const std::function<void(std::uint64_t)>& take);

/// A result as text; bytes of file names and arguments that are no UTF-8 become U+FFFD, for a result is not
/// lost over a name. Indent -1: one line.
std::string json_text(const nlohmann::ordered_json& result, int indent = 1);

/// The same on standard output, with a line end.
void print_json(const nlohmann::ordered_json& result);

}  // namespace palpate::app
