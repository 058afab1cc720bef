#pragma once

#include <CLI/CLI.hpp>

namespace palpate::app {

/// Thrown by a command that was stopped by Ctrl-C, once everything is safe: exit code 130.
struct Interrupted {};

// One file a command: <name>.cpp adds its options and what it runs. Bad input is thrown as
// std::invalid_argument (exit code 1), a machine or device that fails as std::runtime_error or
// std::system_error (exit code 3).
void add_check(CLI::App& app);
void add_cost(CLI::App& app);
void add_demo(CLI::App& app);
void add_export(CLI::App& app);
void add_merge(CLI::App& app);
void add_mesh(CLI::App& app);
void add_plan(CLI::App& app);
void add_press(CLI::App& app);
void add_render(CLI::App& app);
void add_report(CLI::App& app);
void add_run(CLI::App& app);
void add_simulate(CLI::App& app);
void add_stats(CLI::App& app);
void add_verify(CLI::App& app);

}  // namespace palpate::app
