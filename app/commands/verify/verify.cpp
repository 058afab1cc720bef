#include "app/commands/verify/verify.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "app/command_line/output.hpp"
#include "app/study/merged_parts_json.hpp"
#include "base/text/counted.hpp"
#include "trials/study/verify.hpp"

namespace palpate::app {
namespace {

struct VerifyOptions {
  std::string study, receipt, format;
};

void print_text(const VerifyOptions& options, const trials::VerifyReport& report) {
  fmt::print("{}: {}, {} ({} voided), {}\n", options.study,
             base::counted(report.sessions, "sitting", "sittings"),
             base::counted(report.answers, "answer", "answers"), report.voided,
             base::counted(report.presentations, "presentation", "presentations"));
  for (const trials::MergedPart& part : report.parts)
    fmt::print("  joined from {}{}: {}, receipt {}\n", part.file,
               part.site.empty() ? "" : fmt::format(" (site {})", part.site),
               base::counted(part.sessions, "sitting", "sittings"), trials::to_string(part.receipt));
  for (const std::string& problem : report.problems) fmt::print("  {}\n", problem);
  for (const std::string& note : report.notes) fmt::print("  note: {}\n", note);
  for (const trials::ClockStep& step : report.clock_steps)
    fmt::print("  note: {}; the chain tells the order all the same\n", in_words(step));
  if (report.problems.empty())
    fmt::print("whole: database, schema, hashes, chain, order and traces fit together{}\n",
               options.receipt.empty() ? "" : ", and so does the receipt");
  if (options.receipt.empty())
    fmt::print(
        "without a receipt (--receipt), cutting back at the end or rewriting from the start cannot be "
        "seen\n");
  if (!report.receipt.head.empty()) fmt::print("receipt {}\n", trials::to_string(report.receipt));
}

nlohmann::ordered_json clock_steps_json(const std::vector<trials::ClockStep>& steps) {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const trials::ClockStep& step : steps)
    json.push_back({{"entry", step.entry}, {"from_utc", step.before_utc}, {"to_utc", step.after_utc}});
  return json;
}

void run_verify(const VerifyOptions& options) {
  const auto receipt =
      options.receipt.empty() ? std::nullopt : std::optional(trials::parse_receipt(options.receipt));
  const trials::VerifyReport report = trials::verify_study(options.study, receipt);
  if (options.format == "json")
    print_json({{"study", options.study},
                {"whole", report.problems.empty()},
                {"problems", report.problems},
                {"notes", report.notes},
                {"sessions", report.sessions},
                {"answers", report.answers},
                {"voided", report.voided},
                {"presentations", report.presentations},
                {"clock_set_back", clock_steps_json(report.clock_steps)},
                {"parts", parts_json(report.parts)},
                {"receipt", report.receipt.head.empty()
                                ? nlohmann::ordered_json()
                                : nlohmann::ordered_json(trials::to_string(report.receipt))}});
  else
    print_text(options, report);
  if (!report.problems.empty())
    throw std::invalid_argument(
        fmt::format("{}: the study file is not whole: {}", options.study,
                    base::counted(std::ssize(report.problems), "problem", "problems")));
}

void add_verify(CLI::App& command) {
  auto options = std::make_shared<VerifyOptions>();
  command.add_option("study", options->study, "Study file")->required();
  command.add_option(
      "--receipt", options->receipt,
      "A receipt printed at a session's end, or the first 16 digits of it and more: also finds later "
      "rewriting or cutting back");
  add_format(command, options->format);
  command.footer(
      "A file that palpate merge made holds its parts' chains as they were: their receipts hold as well.\n\n"
      "Example:\n  palpate verify study.db --receipt 120-9f86d0...\nExit code 1: something is wrong.");
  command.callback([options] { run_verify(*options); });
}

}  // namespace

const Command verify_command{.name = "verify",
                             .summary = "Checks that a study file is whole and was not tampered with",
                             .heading = "Read a study",
                             .add = add_verify};

}  // namespace palpate::app
