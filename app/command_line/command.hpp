#pragma once

#include <CLI/CLI.hpp>
#include <string_view>

namespace palpate::app {

/// A command of `palpate`: a folder of app/commands, and a line of the list there.
/// Bad input is thrown as std::invalid_argument (exit code 1), a machine or device that fails as
/// std::runtime_error or std::system_error (exit code 3), an end by Ctrl-C as Interrupted (exit code 130).
struct Command {
  std::string_view name;           // as it is typed
  std::string_view summary;        // its line of `palpate --help`
  std::string_view heading;        // that the line stands under
  void (*add)(CLI::App& command);  // options, help with an example, and what is run
};

}  // namespace palpate::app
