#include "app/commands/run/run.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "app/command_line/interrupt.hpp"
#include "app/command_line/user_cache.hpp"
#include "app/web/host/host.hpp"
#include "app/web/host/kept_link.hpp"
#include "base/machine/machine.hpp"
#include "devices/devices.hpp"
#include "sim/compile/compile.hpp"
#include "trials/protocol/protocol.hpp"
#include "trials/session/session.hpp"
#include "trials/study/study_file.hpp"

namespace palpate::app {
namespace {

struct RunOptions {
  std::string protocol, study, examinee, device;
  bool pilot = false, practice = false, new_session = false, no_browser = false;
  std::uint16_t port = 0;
};

/// Devices that a person's hand moves, as --device takes them.
std::vector<std::string> device_names() {
  std::vector<std::string> names;
  for (const devices::Device* device : devices::all())
    if (device->facts.moved_by_a_person) names.emplace_back(device->name);
  return names;
}

/// "What presses; in this version a mouse"
std::string device_help() {
  std::string text;
  for (const devices::Device* device : devices::all())
    if (device->facts.moved_by_a_person)
      text += fmt::format("{}{}", text.empty() ? "What presses; in this version " : " or ", device->in_words);
  return text;
}

trials::SessionFacts facts_of(const RunOptions& options, const devices::Device& device) {
  return {.examinee = options.examinee,
          .run_mode = options.pilot      ? trials::RunMode::Pilot
                      : options.practice ? trials::RunMode::Practice
                                         : trials::RunMode::Study,
          .software_version = PALPATE_VERSION,
          .machine = base::describe_machine(),
          .device = std::string(device.name),
          .pseudo_haptic = !device.facts.gives_force,
          .channel = std::string(device.facts.channel)};
}

Organs prepare_organs(const trials::Protocol& protocol) {
  std::fputs("Preparing the organs...\n", stderr);
  sim::ComplianceCache cache = user_cache();
  return {.stimuli = trials::compile_stimuli(protocol, cache),
          .practice = sim::compile(sim::load_scene(protocol.scene_file), cache)};
}

/// Everything that can fail is tried before the study file is touched.
void run_run(const RunOptions& options) {
  const trials::Protocol protocol = trials::load_protocol(options.protocol);
  devices::OpenDevice device = devices::open(options.device);
  const trials::SessionFacts facts = facts_of(options, *device.device);
  trials::check_start(options.study, protocol, facts, options.new_session);
  const Organs organs = prepare_organs(protocol);
  Host host({.port = options.port,
             .open_browser = !options.no_browser,
             .kept_link = kept_link_file(options.study),
             .sitting = fmt::format("{} {}", facts.examinee, trials::to_string(facts.run_mode))});

  trials::StudyFile study = trials::open_study(options.study, protocol, PALPATE_VERSION);
  trials::Session session = trials::start_session(study, protocol, facts, options.new_session);
  const int all = trials::trials_per_session(protocol);
  if (session.view().resumed)
    fmt::print(stderr, "{} has an unfinished session: it goes on, {} of {} questions are answered.\n",
               options.examinee, session.answered(), all);

  const HostEnd end = host.lead(session, protocol, organs, std::move(device));
  fmt::print("{}: {} of {} questions answered, all saved in {}\n", options.examinee, session.answered(), all,
             options.study);
  fmt::print("receipt {}\n", trials::to_string(session.receipt()));
  if (end == HostEnd::Complete) return;
  fmt::print(stderr, "The session is paused; the same command takes it up again.\n");
  throw Interrupted{};
}

void add_run(CLI::App& command) {
  auto options = std::make_shared<RunOptions>();
  command.add_option("protocol", options->protocol, "Protocol file (.toml)")->required();
  command.add_option("--study", options->study, "Study file; made if there is none")->required();
  command.add_option("--examinee", options->examinee, "The examinee's code (never a name), e.g. P01")
      ->required();
  auto* pilot =
      command.add_flag("--pilot", options->pilot, "A pilot: kept, and left out of the study's results");
  command.add_flag("--practice", options->practice, "Practice: kept, and left out of the study's results")
      ->excludes(pilot);
  command.add_flag("--new-session", options->new_session, "Begin one more session of this examinee");
  command.add_flag("--no-browser", options->no_browser, "Print the link and open nothing");
  command.add_option("--device", options->device, device_help())
      ->check(CLI::IsMember(device_names()))
      ->default_val(device_names().front());
  command.add_option("--port", options->port, "Port on 127.0.0.1 (default: one that is free)");
  command.footer(
      "Without a haptic device the mouse presses: the session is pseudo-haptic and is marked so.\n"
      "An unfinished session is taken up where it stopped.\n\n"
      "Example:\n  palpate run protocols/kuroda2003.toml --study s.db --examinee P01");
  command.callback([options] { run_run(*options); });
}

}  // namespace

const Command run_command{.name = "run",
                          .summary = "Runs a session with a person, in the browser",
                          .heading = "Run a study",
                          .add = add_run};

}  // namespace palpate::app
