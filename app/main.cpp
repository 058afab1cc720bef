#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <stdexcept>

#include "app/commands/commands.hpp"

namespace {

enum ExitCode { kDone = 0, kWrongInput = 1, kUsage = 2, kMachineFailed = 3, kInterrupted = 130 };

int report(const char* message, ExitCode code) {
  std::fprintf(stderr, "Error: %s\n", message);
  return code;
}

}  // namespace

int main(int argc, char** argv) {
  spdlog::set_default_logger(spdlog::stderr_color_mt("palpate"));
  spdlog::set_pattern("%v");

  CLI::App app("palpate: touch simulated organs, run forced-choice studies on them, and test what was felt.",
               "palpate");
  app.set_version_flag("--version", PALPATE_VERSION);
  app.require_subcommand(0, 1);
  palpate::app::add_check(app);
  palpate::app::add_cost(app);
  palpate::app::add_demo(app);
  palpate::app::add_export(app);
  palpate::app::add_merge(app);
  palpate::app::add_mesh(app);
  palpate::app::add_plan(app);
  palpate::app::add_press(app);
  palpate::app::add_render(app);
  palpate::app::add_report(app);
  palpate::app::add_run(app);
  palpate::app::add_simulate(app);
  palpate::app::add_stats(app);
  palpate::app::add_verify(app);

  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    const int code = app.exit(error);
    return code == 0 ? kDone : kUsage;
  } catch (const palpate::app::Interrupted&) {
    return kInterrupted;
  } catch (const std::invalid_argument& error) {
    return report(error.what(), kWrongInput);
  } catch (const std::exception& error) {
    return report(error.what(), kMachineFailed);
  }
  if (app.get_subcommands().empty()) std::fputs(app.help().c_str(), stdout);
  return kDone;
}
