#include "base/text/file_format.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

namespace palpate::base {
namespace {

constexpr std::size_t kWidth = 100;  // of a comment line

/// As comment lines; code is not marked there.
std::string commented(std::string_view text, std::string_view first = "# ", std::string_view next = "# ") {
  std::string plain(text);
  std::erase(plain, '`');
  std::istringstream words(plain);
  std::string lines, line(first);
  bool empty = true;
  for (std::string word; words >> word; empty = false) {
    if (!empty && line.size() + 1 + word.size() > kWidth) {
      lines += line + "\n";
      line = std::string(next) + word;
    } else {
      line += (empty ? "" : " ") + word;
    }
  }
  return empty ? "" : lines + line + "\n";
}

bool is_section(const Key& key) {
  return key.takes.kind == Takes::Kind::Table;
}

/// "depth = \"5 mm\""
std::string line_of(const Key& key, const ShownTable& shown) {
  const auto other = shown.examples.find(key.name);
  const std::string_view value =
      other == shown.examples.end() ? key.example : std::string_view(other->second);
  return key.name == kAnyName ? std::string(value) : fmt::format("{} = {}", key.name, value);
}

bool is_commented_out(const Key& key) {
  return !is_required(key) && !key.in_use && key.name != kAnyName;
}

std::string explained(const Key& key, const ShownTable& shown) {
  std::string text = commented(key.meaning);
  if (key.takes.kind == Takes::Kind::Word)
    for (const Word& known : key.takes.words().now)
      if (!known.meaning.empty())
        text += commented(fmt::format("{}: {}", known.word, known.meaning), "#   ", "#     ");
  if (!is_required(key) && key.name != kAnyName)
    text += commented(fmt::format("Left out: {}.", key.fallback.empty() ? key.absent : key.fallback));
  return text + fmt::format("{}{}\n", is_commented_out(key) ? "#" : "", line_of(key, shown));
}

/// A table of the example file: its first appearance explains every key, a further one has what it needs.
std::string shown_text(const TableFormat& table, const ShownTable& shown, bool first, bool continues) {
  std::string text;
  if (!shown.path.empty() && !continues)
    text += "\n" + (first ? commented(table.meaning) : "") + fmt::format("[{}]\n", shown.path);
  bool below_heading = !text.empty();
  for (const Key& key : table.keys) {
    if (is_section(key)) continue;
    if (first)
      text += (below_heading ? "" : "\n") + explained(key, shown);
    else if (!is_commented_out(key))
      text += line_of(key, shown) + "\n";
    below_heading = false;
  }
  return text;
}

// ---- the reference ----

std::string heading(const TableFormat& table) {
  if (table.path.empty()) return "The top of the file";
  if (table.called.empty()) return fmt::format("`[{}]`", table.path);
  return fmt::format(
      "`[{}]`, {}", table.path,
      table.called.find('=') == std::string::npos ? table.called : fmt::format("`{}`", table.called));
}

std::string value_in_words(const Key& key) {
  const Takes& takes = key.takes;
  switch (takes.kind) {
    case Takes::Kind::Text:
      return "text";
    case Takes::Kind::Texts:
      return "texts";
    case Takes::Kind::Boolean:
      return "`true` or `false`";
    case Takes::Kind::Word: {
      std::string text = "one of";
      for (const Word& known : takes.words().now)
        text += fmt::format("{} `\"{}\"`", text == "one of" ? "" : ",", known.word);
      return text;
    }
    case Takes::Kind::Quantity:
      return fmt::format("{}{} ({})", in_words(takes.dimension),
                         bounds_in_words(takes.bounds, si_unit(takes.dimension)),
                         unit_names(takes.dimension));
    case Takes::Kind::Quantities:
      return fmt::format("three {}s ({})", in_words(takes.dimension), unit_names(takes.dimension));
    default:
      return accepted(Key{.name = key.name, .takes = takes});
  }
}

std::string absence(const Key& key) {
  if (is_required(key)) return "required";
  return key.fallback.empty() ? std::string(key.absent) : fmt::format("`{}`", key.fallback);
}

std::string words_in_words(const Key& key) {
  if (key.takes.kind != Takes::Kind::Word) return "";
  const Words words = key.takes.words();
  std::string text;
  for (const Word& known : words.now)
    if (!known.meaning.empty()) text += fmt::format("- `\"{}\"`: {}\n", known.word, known.meaning);
  std::string later;
  for (const std::string_view word : words.later)
    later += fmt::format("{}`\"{}\"`", later.empty() ? "" : ", ", word);
  if (!later.empty()) text += fmt::format("- not in this version: {}\n", later);
  return text.empty() ? "" : fmt::format("\n`{}`:\n\n{}", key.name, text);
}

std::string row(const Key& key, const ShownTable& shown) {
  const bool any = key.name == kAnyName;
  return fmt::format("| {} | {} | {} | {} | {}`{}` |\n",
                     any ? "`\"KEY OF THE SCENE\"`" : fmt::format("`{}`", key.name), value_in_words(key),
                     absence(key), key.meaning, key.along.empty() ? "" : fmt::format("`{}`<br>", key.along),
                     line_of(key, shown));
}

std::string section(const TableFormat& table) {
  std::string text = fmt::format("\n## {}\n", heading(table));
  if (!table.meaning.empty()) text += fmt::format("\n{}\n", table.meaning);
  text += "\n| key | value | left out | meaning | example |\n|---|---|---|---|---|\n";
  const ShownTable shown = table.shown.empty() ? ShownTable{} : table.shown.front();
  for (const Key& key : table.keys)
    if (!is_section(key)) text += row(key, shown);
  for (const Key& key : table.keys) text += words_in_words(key);
  return text;
}

}  // namespace

std::string example_file(const FileFormat& format, std::string_view heading) {
  std::string text;
  std::istringstream lines{std::string(heading)};
  for (std::string line; std::getline(lines, line);) text += fmt::format("# {}\n", line);
  std::string last = "none";
  for (const TableFormat& table : format.tables)
    for (const ShownTable& shown : table.shown) {
      text += shown_text(table, shown, &shown == &table.shown.front(), shown.path == last);
      last = shown.path;
    }
  return text;
}

std::string reference(const FileFormat& format, std::string_view heading) {
  std::string text = fmt::format("# The {} file\n\n{}\n\n", format.name, format.introduction);
  text += fmt::format(
      "Every quantity is a text with its unit. A key that is not below is an error, and so is a value that is "
      "not accepted: the message names file, line and key, what was found and what is accepted. (This page is "
      "what `palpate new --reference {}` prints.)\n\n## A whole file\n\n```toml\n{}```\n",
      format.name, example_file(format, heading));
  for (const TableFormat& table : format.tables) text += section(table);
  if (!format.apart.empty()) {
    text += "\n## What cannot be combined\n\nOne file that calls for both is refused:\n\n";
    for (const std::string& apart : format.apart) text += fmt::format("- {}\n", apart);
  }
  if (!format.later.empty()) {
    text += "\n## Of later versions\n\nThese keys are refused as not in this version:";
    for (const std::string& key : format.later)
      text += fmt::format("{} `{}`", &key == &format.later.front() ? "" : ",", key);
    text += ".\n";
  }
  return text;
}

}  // namespace palpate::base
