#include "app/study/simulation.hpp"

#include <fmt/format.h>

#include "app/command_line/data_folder.hpp"
#include "app/command_line/interrupt.hpp"
#include "app/command_line/progress.hpp"
#include "app/command_line/user_cache.hpp"
#include "base/machine/machine.hpp"
#include "base/text/counted.hpp"

namespace palpate::app {

std::filesystem::path default_observer() {
  return data_folder() / "protocols/observers/default.toml";
}

SimulationResult run_simulation(const std::filesystem::path& protocol_file,
                                const std::filesystem::path& study_file, int examinees,
                                const std::filesystem::path& observer, trials::Seed seed) {
  const trials::Protocol protocol = trials::load_protocol(protocol_file);
  trials::SimulationPlan plan{
      .examinees = examinees, .observer = trials::load_observer(observer), .seed = seed};
  plan.software_version = PALPATE_VERSION;
  plan.machine = base::describe_machine();
  trials::check_simulation(study_file, protocol, plan);
  sim::ComplianceCache cache = user_cache();
  const trials::Stimuli stimuli = trials::compile_stimuli(protocol, cache);
  trials::check_clamping(protocol, stimuli, plan.observer);

  catch_interrupts();
  trials::StudyFile study = trials::open_study(study_file, protocol, PALPATE_VERSION);
  SimulationResult result;
  {
    ProgressBar bar("simulating");
    result.report = trials::simulate(study, protocol, stimuli, plan, [&](int done, int total) {
      bar.show(done, total);
      return !interrupted();
    });
  }
  result.receipt = study.receipt();
  if (result.report.interrupted) {
    fmt::print(stderr, "stopped: {} given and kept; the same command goes on from there\n",
               base::counted(result.report.answers, "answer is", "answers are"));
    throw Interrupted{};
  }
  return result;
}

}  // namespace palpate::app
