#include <fmt/core.h>

#include "analysis/report/page_style.hpp"
#include "analysis/report/pictures.hpp"
#include "analysis/report/summary.hpp"
#include "analysis/report/svg.hpp"
#include "analysis/report/tables.hpp"
#include "analysis/report/write_report.hpp"
#include "analysis/words/words.hpp"

namespace palpate::analysis {
namespace {

// A number and its per cent sign stay on one line.
std::string html(std::string_view text) {
  std::string safe = escape(text);
  for (std::size_t at = safe.find(" %"); at != std::string::npos; at = safe.find(" %", at + 1)) {
    safe.replace(at, 1, "&#160;");
  }
  return safe;
}

std::string paragraph(const std::string& text, std::string_view style = "") {
  if (text.empty()) return "";
  return fmt::format("<p{}>{}</p>\n", style.empty() ? "" : fmt::format(" class=\"{}\"", style), html(text));
}

std::string html_table(const TextTable& table) {
  std::string text =
      fmt::format("<div class=\"scroll\"><table>\n<caption>{}</caption>\n<thead><tr>", escape(table.title));
  for (const std::string& name : table.header) text += fmt::format("<th scope=\"col\">{}</th>", escape(name));
  text += "</tr></thead>\n<tbody>\n";
  for (const std::vector<std::string>& row : table.rows) {
    text += fmt::format("<tr><th scope=\"row\">{}</th>", escape(row.front()));
    for (std::size_t c = 1; c < row.size(); ++c) text += fmt::format("<td>{}</td>", html(row[c]));
    text += "</tr>\n";
  }
  return text + "</tbody></table></div>\n" + paragraph(table.note, "note");
}

std::string figure(const std::string& drawing, const std::string& caption) {
  if (drawing.empty()) return "";
  return fmt::format("<figure>\n{}<figcaption>{}</figcaption>\n</figure>\n", drawing, html(caption));
}

std::string heading(const std::string& id, const std::string& text, const std::string& label = "") {
  const std::string tag = label.empty() ? ""
                                        : fmt::format("<span class=\"label{}\">{}</span>",
                                                      label == "primary" ? " primary" : "", escape(label));
  return fmt::format("<section aria-labelledby=\"{0}\">\n<h2 id=\"{0}\">{1}{2}</h2>\n", id, escape(text),
                     tag);
}

const std::string kEnd = "</section>\n";

std::string header(const StudyReport& report) {
  std::string text = fmt::format("<h1>{}: significance report</h1>\n", escape(report.design.protocol_name));
  text += paragraph(
      fmt::format(
          "Run mode: {}. {} of {} planned examinees complete.{}", report.run_mode, report.complete_examinees,
          report.planned_examinees,
          report.options.written_utc.empty() ? "" : fmt::format(" Written {}.", report.options.written_utc)),
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
    subjects.push_back(fmt::format("{} against {}:", comparison.first, comparison.second));
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
  for (const std::string& sentence : report.summary) text += summary_paragraph(report, sentence);
  return text + "</div>\n" + kEnd;
}

std::string primary_section(const StudyReport& report) {
  const std::string caption = fmt::format(
      "Correct answers of all examinees together (bars) with their {} interval. The grey "
      "hill is the number that guessing would give; where it is dark, and from the black "
      "line on, guessing is rejected. Dashed: chance.",
      short_percent(report.options.level));
  return heading("primary", "Did anybody tell the conditions apart?", "primary") +
         figure(answers_picture(report), caption) + html_table(primary_table(report)) +
         paragraph(report.pooled_claim, "claim") + kEnd;
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
         html_table(people_table(report)) + paragraph(report.people_claim, "claim") + kEnd;
}

std::string comparison_section(const StudyReport& report) {
  if (report.comparisons.empty()) return "";
  return heading("comparison", "Does it matter which cell it is?",
                 report.design.between_models == "none" ? "secondary" : "planned comparison") +
         html_table(comparison_table(report)) + paragraph(report.comparison_claim, "claim") + kEnd;
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
  return text + kEnd;
}

std::string response_time_section(const StudyReport& report) {
  const TextTable table = response_time_table(report);
  if (table.rows.empty()) return "";
  return heading("times", "How long did the answers take?", "secondary") +
         figure(times_picture(report),
                "Thin line: from the fastest to the slowest answer; box: the middle half; black line: the "
                "median.") +
         html_table(table) + kEnd;
}

std::string plan_section(const StudyReport& report) {
  std::string text = heading("plan", "Plan and deviations");
  for (const std::string& words : report.plan) text += paragraph(words);
  if (report.deviations.empty())
    return text + paragraph("Nothing that the study file can tell deviates from it.") + kEnd;
  text += "<ul>\n";
  for (const std::string& deviation : report.deviations)
    text += fmt::format("<li>{}</li>\n", html(deviation));
  return text + "</ul>\n" + kEnd;
}

std::string method_sections(const StudyReport& report) {
  std::string text = heading("method", "Method");
  for (const std::string& words : report.method) text += paragraph(words);
  text += kEnd + heading("limits", "Limits") + "<ul>\n";
  for (const std::string& limit : report.limits) text += fmt::format("<li>{}</li>\n", html(limit));
  text += "</ul>\n" + kEnd;
  if (report.voided.empty()) return text;
  return text + heading("voided", "Voided trials") + html_table(voided_table(report)) + kEnd;
}

std::string provenance_section(const StudyReport& report) {
  std::string text = heading("provenance", "Where the numbers come from") + html_table(session_table(report));
  text += fmt::format("<p>Protocol <code>{}</code> (SHA-256). Report computed by palpate {}.</p>\n",
                      escape(report.design.protocol_sha256), escape(report.options.software_version));
  if (!report.options.receipt.empty())
    text += fmt::format(
        "<p>Computed from a study file with the receipt <code>{0}</code>: <code>palpate verify STUDY "
        "--receipt {0}</code> tells whether a file still holds these answers.</p>\n",
        escape(report.options.receipt));
  if (!report.withheld) text += html_table(examinee_table(report));
  if (!report.curves.empty()) text += html_table(curve_table(report));
  if (!report.design.protocol_text.empty()) {
    text += fmt::format("<h3>The protocol as it was run</h3>\n<pre>{}</pre>\n",
                        escape(report.design.protocol_text));
  }
  return text + kEnd;
}

std::string answers_as_html(const StudyReport& report) {
  return heading("answers", "Answers so far") + html_table(answers_table(report)) + kEnd;
}

std::string results_as_html(const StudyReport& report) {
  return primary_section(report) + people_section(report) + comparison_section(report) +
         heading("sensitivity", "Sensitivity and the order of the intervals", "secondary") +
         figure(orders_picture(report),
                fmt::format("Percentage correct (dot) with its {} interval, by the interval that held {}. "
                            "Dashed: chance.",
                            short_percent(report.options.level), report.design.correct_condition)) +
         html_table(sensitivity_table(report)) + kEnd + response_time_section(report) +
         stimulus_section(report);
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
