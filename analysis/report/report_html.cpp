#include <fmt/core.h>

#include "analysis/report/html_parts.hpp"
#include "analysis/report/page_style.hpp"
#include "analysis/report/pictures.hpp"
#include "analysis/report/summary.hpp"
#include "analysis/report/svg.hpp"
#include "analysis/report/tables.hpp"
#include "analysis/report/verdict.hpp"
#include "analysis/report/write_report.hpp"
#include "analysis/words/words.hpp"

namespace palpate::analysis {
namespace {

std::string header(const StudyReport& report) {
  std::string text = fmt::format("<h1>{}: significance report</h1>\n", escape(report.design.protocol_name));
  text +=
      paragraph(fmt::format("Run mode: {}. {} of {} planned examinees complete.{}", report.run_mode,
                            report.complete_examinees, report.planned_examinees,
                            report.options.written_utc.empty()
                                ? ""
                                : fmt::format(" Written {} UTC.", to_the_second(report.options.written_utc))),
                "meta");
  for (const std::string& banner : report.banners) {
    text += fmt::format("<p class=\"banner\" role=\"note\">{}</p>\n", escape(banner));
  }
  return text;
}

// The first words of each banner, small, at the head of every printed page.
std::string running_head(const StudyReport& report) {
  std::string text = report.design.protocol_name;
  for (const std::string& banner : report.banners) text += " | " + banner.substr(0, banner.find(':'));
  return fmt::format("<div class=\"running\" aria-hidden=\"true\"><div>{}</div></div>\n", escape(text));
}

// What a paragraph is about stands in bold.
std::string summary_paragraph(const StudyReport& report, const std::string& sentence) {
  std::vector<std::string> subjects;
  for (const CellComparison& comparison : report.comparisons) {
    subjects.push_back(name_of(comparison.contrast) + ":");
  }
  for (const CellResult& cell : report.cells) subjects.push_back(cell.name + ":");
  for (const std::string& subject : subjects) {
    if (!sentence.starts_with(subject)) continue;
    return fmt::format("<p><strong>{}</strong>{}</p>\n", escape(subject),
                       html(sentence.substr(subject.size())));
  }
  return paragraph(sentence);
}

std::string summary_section(const StudyReport& report) {
  std::string text = heading("summary", "Summary") + "<div class=\"summary\">\n";
  if (!report.withheld) text += html_table(verdict_table(report));
  for (const std::string& sentence : report.summary) text += summary_paragraph(report, sentence);
  return text + "</div>\n" + kSectionEnd;
}

std::string primary_section(const StudyReport& report) {
  const std::string caption = fmt::format(
      "Correct answers of all examinees together (bars) with their {} interval. The grey "
      "hill is the number that guessing would give; where it is dark, and from the black "
      "line on, guessing is rejected{}. Dashed: chance.",
      short_percent(report.options.level),
      report.design.adjust == "none" ? ""
                                     : fmt::format(", before the adjustment ({}) that the verdict counts",
                                                   adjustment_in_words(report.design.adjust)));
  return heading("primary", "Did anybody tell the conditions apart?", "primary") +
         figure(answers_picture(report), caption) + html_table(primary_table(report)) +
         optional_table(evidence_table(report)) + paragraph(report.pooled_claim, "claim") + kSectionEnd;
}

std::string people_section(const StudyReport& report) {
  return heading(
             "people",
             report.run_mode == "simulated" ? "Do simulated examinees in general?" : "Do people in general?",
             "secondary") +
         figure(examinees_picture(report),
                report.examinees.size() > kMostRows
                    ? "Examinees by their percentage correct, in steps of 5 %. Dashed: chance."
                    : "Percentage correct of each examinee; a grey line joins the cells of one examinee. "
                      "Dashed: chance." +
                          std::string(report.sample &&
                                              *report.sample < static_cast<long>(report.examinees.size())
                                          ? " A row without marks: an examinee who is not counted."
                                          : "")) +
         html_table(people_table(report)) + paragraph(report.people_claim, "claim") + kSectionEnd;
}

std::string comparison_section(const StudyReport& report) {
  if (report.comparisons.empty()) return "";
  return heading("comparison", fmt::format("Does {} matter?", factors_in_words(report.design)),
                 report.design.between_models == "none" ? "secondary" : "planned comparison") +
         html_table(comparison_table(report)) + paragraph(report.comparison_claim, "claim") + kSectionEnd;
}

std::string stimulus_section(const StudyReport& report) {
  const std::string curves = curves_picture(report);
  if (curves.empty() && report.stimuli.empty()) return "";
  std::string text = heading("stimuli", "What was presented");
  text +=
      figure(curves,
             "Force on the finger over the depth of the press, as presented: mean over presses, band: one "
             "standard deviation between them.");
  text += figure(
      loop_picture(report),
      "The haptic loop: the time within which 99.9 % of the cycles followed the one before, in the worst "
      "interval of each stimulus. Dashed: the period of 1 ms that is aimed at.");
  if (!report.stimuli.empty()) text += html_table(stimulus_table(report));
  return text + kSectionEnd;
}

std::string learning_section(const StudyReport& report) {
  const TextTable table = learning_table(report);
  if (table.rows.empty()) return "";
  return heading("learning", "Did answers change over the trials?", "secondary") + html_table(table) +
         kSectionEnd;
}

std::string response_time_section(const StudyReport& report) {
  const TextTable table = response_time_table(report);
  if (table.rows.empty()) return "";
  return heading("times", "How long did the answers take?", "secondary") +
         figure(times_picture(report),
                "Thin line: from the fastest to the slowest answer; box: the middle half; black line: the "
                "median.") +
         html_table(table) + kSectionEnd;
}

std::string plan_section(const StudyReport& report) {
  std::string text = heading("plan", "Plan and deviations");
  for (const std::string& words : report.plan) text += paragraph(words);
  if (report.deviations.empty())
    return text + paragraph("Nothing that the study file can tell deviates from it.") + kSectionEnd;
  text += "<ul>\n";
  for (const std::string& deviation : report.deviations)
    text += fmt::format("<li>{}</li>\n", html(deviation));
  return text + "</ul>\n" + kSectionEnd;
}

std::string method_sections(const StudyReport& report) {
  std::string text = heading("method", "Method");
  for (const std::string& words : report.method) text += paragraph(words);
  text += kSectionEnd + heading("limits", "Limits") + "<ul>\n";
  for (const std::string& limit : report.limits) text += fmt::format("<li>{}</li>\n", html(limit));
  text += "</ul>\n" + kSectionEnd;
  if (report.voided.empty()) return text;
  return text + heading("voided", "Voided trials") + html_table(voided_table(report)) + kSectionEnd;
}

std::string provenance_section(const StudyReport& report) {
  std::string text = heading("provenance", "Where the numbers come from");
  text += paragraph(sessions_in_words(report)) + folded_table(session_table(report), "sessions");
  text += fmt::format("<p>Protocol <code>{}</code> (SHA-256). Report computed by palpate {}.</p>\n",
                      escape(report.design.protocol_sha256), escape(report.options.software_version));
  if (!report.options.receipt.empty())
    text += fmt::format(
        "<p>Computed from a study file with the receipt <code>{0}</code>: <code>palpate verify STUDY "
        "--receipt {0}</code> tells whether a file still holds these answers.</p>\n",
        escape(report.options.receipt));
  if (!report.withheld) text += folded_table(examinee_table(report), "examinees");
  if (!report.curves.empty()) text += folded_table(curve_table(report), "force-depth");
  if (!report.design.protocol_text.empty()) {
    text += fmt::format("<h3>The protocol as it was run</h3>\n<pre>{}</pre>\n",
                        escape(report.design.protocol_text));
  }
  return text + kSectionEnd;
}

std::string answers_as_html(const StudyReport& report) {
  return heading("answers", "Answers so far") + html_table(answers_table(report)) + kSectionEnd;
}

std::string results_as_html(const StudyReport& report) {
  return primary_section(report) + people_section(report) + comparison_section(report) +
         heading("sensitivity", "Sensitivity and the order of the intervals", "secondary") +
         figure(orders_picture(report),
                fmt::format("Percentage correct (dot) with its {} interval, by the interval that held {}. "
                            "Dashed: chance.",
                            short_percent(report.options.level), report.design.correct_condition)) +
         html_table(sensitivity_table(report)) + kSectionEnd + learning_section(report) +
         response_time_section(report) + stimulus_section(report);
}

}  // namespace

std::string html_report(const StudyReport& report) {
  return fmt::format(
             "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\"/>\n"
             "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n"
             "<title>{}: significance report</title>\n<style>{}</style>\n</head>\n<body>\n"
             "<div class=\"sheet\">\n{}<main>\n",
             escape(report.design.protocol_name), kPageStyle, running_head(report)) +
         header(report) + summary_section(report) +
         (report.withheld ? answers_as_html(report) : results_as_html(report)) + plan_section(report) +
         method_sections(report) + provenance_section(report) + "</main>\n</div>\n</body>\n</html>\n";
}

}  // namespace palpate::analysis
