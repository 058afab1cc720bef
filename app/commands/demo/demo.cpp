#include "app/commands/demo/demo.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>
#include <system_error>

#include "analysis/report/write_report.hpp"
#include "app/command_line/output.hpp"
#include "app/study/simulation.hpp"
#include "app/study/study_table.hpp"
#include "base/clock/utc.hpp"
#include "base/files/atomic_file.hpp"
#include "base/files/file_error.hpp"
#include "base/text/counted.hpp"

namespace palpate::app {
namespace {

struct DemoOptions {
  std::string out = "palpate-demo";
  int examinees = 15;
  trials::Seed seed{};
  bool full = false;
};

/// `wanted`, or `wanted`-2, -3, ...: the first folder that is not there yet, so that no study is written
/// over.
std::filesystem::path fresh_folder(const std::filesystem::path& wanted) {
  std::filesystem::path folder = wanted;
  for (int number = 2; std::filesystem::exists(folder); ++number)
    folder = fmt::format("{}-{}", wanted.string(), number);
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error == std::errc::not_a_directory)
    throw std::invalid_argument(
        fmt::format("--out {}: a part of it is a file; accepted: a folder, or a name that is not taken",
                    wanted.string()));
  if (error) base::throw_cannot(error.value(), "make a folder there", folder);
  return folder;
}

void run_demo(const DemoOptions& options) {
  const std::filesystem::path observer = default_observer();
  const std::filesystem::path protocol = observer.parent_path().parent_path() / "kuroda2003.toml";
  const std::filesystem::path folder = fresh_folder(options.out);
  const std::filesystem::path study = folder / "study.db", page = folder / "report.html";

  fmt::print(stderr, "The study of Kuroda et al. 2003 with {}, in {}\n",
             base::counted(options.examinees, "simulated examinee", "simulated examinees"), study.string());
  const SimulationResult result = run_simulation(protocol, study, options.examinees, observer, options.seed);
  const analysis::StudyReport report = analysis::analyse(read_study_table(trials::read_study(study)),
                                                         {.run_mode = "simulated",
                                                          .software_version = PALPATE_VERSION,
                                                          .written_utc = base::utc_now(),
                                                          .receipt = trials::to_string(result.receipt)});
  base::write_atomically(page, analysis::html_report(report));
  fmt::print("{}\n", brief(options.full) ? analysis::brief_report(report, terminal_width())
                                         : analysis::text_report(report));
  fmt::print("study    {}\nreport   {} (open it in a browser)\nreceipt  {}\n", study.string(), page.string(),
             trials::to_string(result.receipt));
}

void add_demo(CLI::App& command) {
  auto options = std::make_shared<DemoOptions>();
  command
      .add_option("--out", options->out,
                  "Folder for study file and report; a number is added where it exists")
      ->capture_default_str();
  command.add_option("--examinees", options->examinees, "How many")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  add_seed(command, "Makes orders and answers repeatable; else the system's entropy",
           [options](std::uint64_t seed) { options->seed = seed; });
  add_full(command, options->full);
  command.footer("Example:\n  palpate demo --seed 1\nNo person takes part; every page says so.");
  command.callback([options] { run_demo(*options); });
}

}  // namespace

const Command demo_command{.name = "demo",
                           .summary = "The 2003 study from start to report, with simulated examinees",
                           .heading = "Begin",
                           .add = add_demo};

}  // namespace palpate::app
