#include "app/commands/report/report.hpp"

#include <fmt/core.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cerrno>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <system_error>

#include "analysis/report/write_report.hpp"
#include "app/command_line/output.hpp"
#include "app/study/look_log.hpp"
#include "app/study/study_table.hpp"
#include "base/clock/utc.hpp"
#include "base/files/atomic_file.hpp"
#include "base/files/file_error.hpp"
#include "base/files/folder_of.hpp"
#include "trials/study/verify.hpp"

namespace palpate::app {
namespace {

struct ReportArguments {
  std::string study, run_mode, out, format;
  bool interim = false, full = false;
};

// A look stays in the study for good, so whatever would keep its page from being written must fail before.
void check_folder_of(const std::filesystem::path& page) {
  base::require_folder_of(page);
  const std::filesystem::path folder = page.has_parent_path() ? page.parent_path() : ".";
  if (::access(folder.c_str(), W_OK | X_OK) != 0)
    base::throw_cannot(errno, "create a file in its folder", page);
  if (std::filesystem::is_directory(page)) base::throw_cannot(EISDIR, "replace", page);
}

/// On a terminal a screenful, and where the rest is.
std::string printed(const analysis::StudyReport& report, const ReportArguments& options) {
  if (options.format == "json") return json_text(analysis::json_report(report)) + "\n";
  if (!brief(options.full)) return analysis::text_report(report);
  return analysis::brief_report(report, terminal_width()) +
         (options.out.empty()
              ? std::string("\nAll of it: --full prints it, --out report.html writes the page.\n")
              : fmt::format("\nAll of it: {} (open it in a browser), or --full.\n", options.out));
}

// A report never takes the place of something that is none.
void check_page(const ReportArguments& options) {
  if (options.out.empty()) return;
  const std::filesystem::path page = options.out;
  if (page.extension() != ".html" && page.extension() != ".htm")
    throw std::invalid_argument(
        fmt::format("--out {}: accepted: a file name that ends in .html", options.out));
  base::require_folder_of(page);
  std::error_code none;
  if (std::filesystem::equivalent(page, options.study, none))
    throw std::invalid_argument(
        fmt::format("--out {}: is the study file itself; accepted: another name", options.out));
}

void run_report(const ReportArguments& options) {
  check_page(options);
  trials::require_whole(options.study);
  analysis::ReportOptions asked{
      .interim = options.interim, .software_version = PALPATE_VERSION, .written_utc = base::utc_now()};
  if (!options.run_mode.empty()) asked.run_mode = options.run_mode;
  const trials::StudyFile study = trials::read_study(options.study);
  asked.receipt = trials::to_string(study.receipt());
  const analysis::StudyTable table = read_study_table(study);
  const analysis::StudyReport report = analysis::analyse(table, asked);
  const std::string text = printed(report, options);
  const std::string page = options.out.empty() ? "" : analysis::html_report(report);
  if (!options.out.empty()) check_folder_of(options.out);
  // A look is written into the study before it is shown, so that none stays unknown.
  if (const auto look = look_to_log(report, table.looks)) log_look(options.study, *look);

  if (!options.out.empty()) {
    base::write_atomically(options.out, page);
    fmt::print(stderr, "Wrote {}\n", options.out);
  }
  fmt::print("{}", text);
}

void add_report(CLI::App& command) {
  const auto options = std::make_shared<ReportArguments>();
  command.add_option("STUDY", options->study, "Study file")->required();
  command
      .add_option("--run-mode", options->run_mode, "Which sessions: study, pilot or simulated; never pooled")
      ->check(CLI::IsMember({"study", "pilot", "simulated"}));
  command.add_flag(
      "--interim", options->interim,
      "Show results though the planned sample is not complete; the look is logged in the study file");
  command.add_option("--out", options->out, "Also write the report as one self-contained HTML page");
  add_full(command, options->full);
  add_format(command, options->format);
  command.footer(
      "The protocol names the primary test; all others are labelled as secondary. Before the planned\n"
      "sample is complete the report counts answers and shows no result.\n\n"
      "Example:\n"
      "  palpate report study.db --out report.html\n");
  command.callback([options] { run_report(*options); });
}

}  // namespace

const Command report_command{.name = "report",
                             .summary = "The significance report of a study",
                             .heading = "Read a study",
                             .add = add_report};

}  // namespace palpate::app
