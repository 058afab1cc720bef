#include <fmt/core.h>
#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>

#include <CLI/CLI.hpp>
#include <csignal>
#include <cstdio>
#include <exception>
#include <span>
#include <stdexcept>
#include <string>

#include "app/command_line/interrupt.hpp"
#include "app/command_line/usage.hpp"
#include "app/commands/commands.hpp"
#include "base/text/json_words.hpp"

namespace {

enum ExitCode { kDone = 0, kWrongInput = 1, kUsage = 2, kMachineFailed = 3, kInterrupted = 130 };

int report(const char* message, ExitCode code) {
  std::fprintf(stderr, "Error: %s\n", message);
  return code;
}

constexpr const char* kGuide =
    "Begin with:\n"
    "  palpate demo                                     a whole study with simulated examinees\n"
    "  palpate press data/scenes/rectal-palpation.toml  how the force grows with depth\n"
    "  palpate check protocols/kuroda2003.toml          what a study amounts to\n"
    "  palpate new my-study                             a study of your own to start from\n\n"
    "palpate COMMAND --help shows a command's options, with an example.";

}  // namespace

int main(int argc, char** argv) {
  // A file that may grow no further, a reader that has gone: told as errors of the write, not a death without
  // a word in the middle of a session.
  std::signal(SIGXFSZ, SIG_IGN);
  std::signal(SIGPIPE, SIG_IGN);
  spdlog::set_default_logger(spdlog::stderr_color_mt("palpate"));
  spdlog::set_pattern("%v");

  CLI::App app("palpate: touch simulated organs, run forced-choice studies on them, and test what was felt.",
               "palpate");
  app.set_version_flag("--version", PALPATE_VERSION);
  app.require_subcommand(0, 1);
  app.failure_message(palpate::app::usage_error);
  app.footer(kGuide);
  for (const palpate::app::Command* command : palpate::app::commands()) {
    CLI::App* added = app.add_subcommand(std::string(command->name), std::string(command->summary));
    command->add(*added->group(std::string(command->heading)));
  }

  try {
    palpate::app::refuse_empty(std::span(argv, argc));
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    const int code = app.exit(error);
    return code == 0 ? kDone : kUsage;
  } catch (const palpate::app::Interrupted&) {
    return kInterrupted;
  } catch (const std::invalid_argument& error) {
    return report(error.what(), kWrongInput);
  } catch (const std::exception& error) {
    return report(palpate::base::json_words(error.what()).c_str(), kMachineFailed);
  }
  if (app.get_subcommands().empty()) std::fputs(app.help().c_str(), stdout);
  if (std::fflush(stdout) != 0 || std::ferror(stdout))
    return report("standard output: cannot be written; the result is lost", kMachineFailed);
  return kDone;
}
