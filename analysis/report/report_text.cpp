#include <fmt/core.h>

#include <algorithm>
#include <string>

#include "analysis/report/summary.hpp"
#include "analysis/report/tables.hpp"
#include "analysis/report/write_report.hpp"
#include "analysis/words/words.hpp"

namespace palpate::analysis {
namespace {

std::string heading(const std::string& text, char underline) {
  return "\n" + text + "\n" + std::string(columns(text), underline) + "\n";
}

std::string laid_out(const TextTable& table) {
  std::vector<std::size_t> widths(table.header.size(), 0);
  const auto measure = [&](const std::vector<std::string>& row) {
    for (std::size_t c = 0; c < row.size(); ++c) widths[c] = std::max(widths[c], columns(row[c]));
  };
  measure(table.header);
  for (const auto& row : table.rows) measure(row);
  const auto write = [&](const std::vector<std::string>& row) {
    std::string text;
    for (std::size_t c = 0; c < row.size(); ++c) {
      const std::string blanks(widths[c] - columns(row[c]) + (c + 1 < row.size() ? 2 : 0), ' ');
      text += row[c] + blanks;
    }
    return "  " + text.substr(0, text.find_last_not_of(' ') + 1) + "\n";
  };
  std::string text = write(table.header);
  for (const auto& row : table.rows) text += write(row);
  return text;
}

std::string with_note(const TextTable& table, std::size_t width = 100) {
  return laid_out(table) + (table.note.empty() ? "" : wrapped(table.note, "", "", width));
}

std::string section(const TextTable& table, const std::string& title, const std::string& claim = "") {
  std::string text = heading(title, '-');
  if (!claim.empty()) text += wrapped(claim);
  return text + with_note(table);
}

std::string primary_as_text(const StudyReport& report) {
  std::string primary = primary_in_words(report.design);
  primary[0] = static_cast<char>(primary[0] - 'A' + 'a');
  std::string text = section(primary_table(report), "Primary test: pooled " + primary, report.pooled_claim);
  if (const TextTable evidence = evidence_table(report); !evidence.rows.empty())
    text += section(evidence, "Secondary: where no difference is shown");
  return text;
}

std::string results_as_text(const StudyReport& report) {
  std::string text = primary_as_text(report);
  text += section(people_table(report), "Secondary: examinee-level test", report.people_claim);
  if (!report.comparisons.empty()) {
    text += section(comparison_table(report), comparison_table(report).title, report.comparison_claim);
  }
  text += section(sensitivity_table(report), "Secondary: sensitivity and interval order");
  if (const TextTable learning = learning_table(report); !learning.rows.empty())
    text += section(learning, "Secondary: learning over the trials");
  return text + section(examinee_table(report), "Correct answers of each examinee");
}

std::string head(const StudyReport& report, std::size_t width = 100) {
  std::string text = fmt::format("Significance report: {}\n", report.design.protocol_name);
  text += fmt::format("Run mode: {}; protocol {}\n", report.run_mode,
                      report.design.protocol_sha256.substr(0, 16));
  for (const std::string& banner : report.banners) text += "\n" + wrapped(banner, "!! ", "!! ", width);
  return text;
}

// Names come from files: nothing in them may steer the terminal.
std::string tame(std::string text) {
  for (char& c : text) {
    if ((static_cast<unsigned char>(c) < 0x20 && c != '\n') || c == 0x7f) c = '?';
  }
  return text;
}

}  // namespace

std::string brief_report(const StudyReport& report, std::size_t width) {
  std::string text = head(report, width) + "\n";
  if (!report.withheld) text += with_note(verdict_table(report), width) + "\n";
  text += wrapped(report.summary.front(), "", "", width);
  for (const CellComparison& comparison : report.comparisons)
    if (comparison.planned != "none")
      text += "\n" + wrapped(comparison_summary(report, comparison), "", "", width);
  if (report.withheld) text += "\n" + wrapped(report.summary.back(), "", "", width);
  return tame(text);
}

std::string text_report(const StudyReport& report) {
  std::string text = head(report) + heading("Summary", '=');
  if (!report.withheld) text += with_note(verdict_table(report)) + "\n";
  for (std::size_t i = 0; i < report.summary.size(); ++i)
    text += (i > 0 ? "\n" : "") + wrapped(report.summary[i]);
  text += report.withheld ? section(answers_table(report), "Answers so far") : results_as_text(report);
  if (const TextTable times = response_time_table(report); !times.rows.empty())
    text += section(times, "Secondary: response times");
  if (!report.stimuli.empty()) text += section(stimulus_table(report), "Stimuli as they were explored");
  if (!report.voided.empty()) text += section(voided_table(report), "Voided trials, not counted");
  text += heading("Plan and deviations", '=');
  for (const std::string& words : report.plan) text += wrapped(words);
  if (report.deviations.empty()) text += "Nothing that the study file can tell deviates from it.\n";
  for (const std::string& deviation : report.deviations) text += wrapped(deviation, "- ", "  ");
  text += heading("Method", '=');
  for (const std::string& paragraph : report.method) text += wrapped(paragraph);
  text += heading("Limits", '=');
  for (const std::string& limit : report.limits) text += wrapped(limit, "- ", "  ");
  text += section(session_table(report), "Sessions");
  text += fmt::format("\nProtocol {}\n", report.design.protocol_sha256);
  if (!report.options.receipt.empty())
    text += fmt::format("Study file with the receipt {}\n", report.options.receipt);
  text += fmt::format(
      "Report by palpate {}{}\n", report.options.software_version,
      report.options.written_utc.empty() ? "" : ", " + to_the_second(report.options.written_utc) + " UTC");
  return tame(text);
}

}  // namespace palpate::analysis
