#pragma once

#include <string>
#include <string_view>

#include "analysis/report/tables.hpp"

namespace palpate::analysis {

// What a report's page is put together from. Texts are escaped here, but for `drawing`, which is SVG.

/// A text; a number and its per cent sign stay on one line.
std::string html(std::string_view text);

/// Nothing where the text is empty. `style` is the name of a CSS class.
std::string paragraph(const std::string& text, std::string_view style = "");

std::string html_table(const TextTable& table);

/// Nothing where the table has no row.
std::string optional_table(const TextTable& table);

/// A table that few will read: closed until somebody opens it; one of more than 100 rows as a compressed CSV file
/// inside the page.
/// @param file  its name, without ending
std::string folded_table(const TextTable& table, std::string_view file);

/// Nothing where the drawing is empty.
std::string figure(const std::string& drawing, const std::string& caption);

/// Begins a section, which kSectionEnd ends. `label` stands beside the heading: "primary", "secondary".
std::string heading(const std::string& id, const std::string& text, const std::string& label = "");
inline const std::string kSectionEnd = "</section>\n";

}  // namespace palpate::analysis
