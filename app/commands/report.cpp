#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "analysis/report/write_report.hpp"
#include "app/commands/commands.hpp"
#include "app/output.hpp"
#include "app/study_table.hpp"
#include "sim/io/atomic_file.hpp"

namespace palpate::app {
namespace {

struct ReportOptions {
  std::string study, run_mode, out, format;
  bool interim = false;
};

// An interim look is written into the study before it is shown, so that none stays unknown.
void log_interim_look(const std::filesystem::path& path, const analysis::StudyReport& report) {
  const trials::Protocol protocol = trials::read_study(path).protocol();
  trials::StudyFile study = trials::open_study(path, protocol, PALPATE_VERSION);
  study.add_event({.kind = std::string(kInterimLook),
                   .text = fmt::format("run mode {}, {} of {} planned examinees complete", report.run_mode,
                                       report.complete_examinees, report.planned_examinees),
                   .utc = trials::utc_now()});
}

void run_report(const ReportOptions& options) {
  analysis::ReportOptions asked{
      .interim = options.interim, .software_version = PALPATE_VERSION, .written_utc = trials::utc_now()};
  if (!options.run_mode.empty()) asked.run_mode = options.run_mode;
  const analysis::StudyTable table = read_study_table(trials::read_study(options.study));
  const analysis::StudyReport report = analysis::analyse(table, asked);
  if (options.interim && !report.complete) log_interim_look(options.study, report);

  if (!options.out.empty()) {
    sim::write_atomically(options.out, analysis::html_report(report));
    fmt::print(stderr, "Wrote {}\n", options.out);
  }
  if (options.format == "json") {
    print_json(analysis::json_report(report));
  } else {
    fmt::print("{}", analysis::text_report(report));
  }
}

}  // namespace

void add_report(CLI::App& app) {
  const auto options = std::make_shared<ReportOptions>();
  CLI::App* command = app.add_subcommand("report", "The significance report of a study");
  command->add_option("STUDY", options->study, "Study file")->required();
  command
      ->add_option("--run-mode", options->run_mode, "Which sessions: study, pilot or simulated; never pooled")
      ->check(CLI::IsMember({"study", "pilot", "simulated"}));
  command->add_flag(
      "--interim", options->interim,
      "Show tests though the planned sample is not complete; the look is logged in the study file");
  command->add_option("--out", options->out, "Also write the report as one self-contained HTML page");
  add_format(*command, options->format);
  command->footer(
      "The protocol names the primary test; all others are labelled as secondary. Before the planned\n"
      "sample is complete the report counts answers and shows no test.\n\n"
      "Example:\n"
      "  palpate report study.db --out report.html\n");
  command->callback([options] { run_report(*options); });
}

}  // namespace palpate::app
