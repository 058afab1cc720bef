#include "analysis/report/html_parts.hpp"

#include <fmt/core.h>

#include "analysis/report/svg.hpp"
#include "analysis/words/words.hpp"
#include "base/text/csv.hpp"
#include "base/text/gzip_link.hpp"

namespace palpate::analysis {
namespace {

constexpr std::size_t kMostRowsOnPage = 100;

std::string csv(const TextTable& table) {
  std::string text;
  const auto add = [&](const std::vector<std::string>& row) {
    for (std::size_t i = 0; i < row.size(); ++i) text += (i > 0 ? "," : "") + base::csv_field(row[i]);
    text += '\n';
  };
  add(table.header);
  for (const std::vector<std::string>& row : table.rows) add(row);
  return text;
}

// A short cell stays on one line.
std::string unbroken(const std::string& text) {
  constexpr std::size_t kShort = 20;
  std::string safe = html(text);
  if (columns(text) > kShort) return safe;
  for (std::size_t at = safe.find(' '); at != std::string::npos; at = safe.find(' ', at + 1))
    safe.replace(at, 1, "&#160;");
  return safe;
}

}  // namespace

// A number and its per cent sign stay on one line.
std::string html(std::string_view text) {
  std::string safe = escape(text);
  for (std::size_t at = safe.find(" %"); at != std::string::npos; at = safe.find(" %", at + 1)) {
    safe.replace(at, 1, "&#160;");
  }
  return safe;
}

std::string paragraph(const std::string& text, std::string_view style) {
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
    for (std::size_t c = 1; c < row.size(); ++c) text += fmt::format("<td>{}</td>", unbroken(row[c]));
    text += "</tr>\n";
  }
  return text + "</tbody></table></div>\n" + paragraph(table.note, "note");
}

std::string optional_table(const TextTable& table) {
  return table.rows.empty() ? "" : html_table(table);
}

std::string figure(const std::string& drawing, const std::string& caption) {
  if (drawing.empty()) return "";
  return fmt::format("<figure>\n{}<figcaption>{}</figcaption>\n</figure>\n", drawing, html(caption));
}

std::string heading(const std::string& id, const std::string& text, const std::string& label) {
  const std::string tag = label.empty() ? ""
                                        : fmt::format("<span class=\"label{}\">{}</span>",
                                                      label == "primary" ? " primary" : "", escape(label));
  return fmt::format("<section aria-labelledby=\"{0}\">\n<h2 id=\"{0}\">{1}{2}</h2>\n", id, escape(text),
                     tag);
}

std::string folded_table(const TextTable& table, std::string_view file) {
  const std::string rows = counted(std::ssize(table.rows), "row", "rows");
  if (table.rows.size() > kMostRowsOnPage)
    return fmt::format(
        "<p><a download=\"{0}.csv.gz\" href=\"{1}\">{2}</a>: {3}, as a compressed CSV file ({0}.csv.gz), which "
        "this page holds.</p>\n",
        file, base::gzip_link(csv(table)), escape(table.title), rows);
  return fmt::format("<details><summary>{} ({})</summary>\n{}</details>\n", escape(table.title), rows,
                     html_table(table));
}

}  // namespace palpate::analysis
