#include "app/number_column.hpp"

#include <fmt/core.h>

#include <charconv>
#include <cmath>
#include <fstream>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>

namespace palpate::app {
namespace {

std::string_view trim(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t\r");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

std::string_view unquote(std::string_view text) {
  const bool quoted = text.size() >= 2 && text.front() == '"' && text.back() == '"';
  return quoted ? trim(text.substr(1, text.size() - 2)) : text;
}

std::optional<double> to_number(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

// A first line that names the column. "NaN" and "n/a" name nothing: they are missing values.
bool is_header(std::string_view text) {
  std::string lower;
  for (const char c : text) lower += static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
  if (lower == "nan" || lower == "na" || lower == "n/a" || lower.starts_with("inf")) return false;
  return (lower[0] >= 'a' && lower[0] <= 'z') || lower[0] == '_' ||
         static_cast<unsigned char>(lower[0]) >= 0x80;
}

[[noreturn]] void refuse(const std::filesystem::path& file, int line, std::string_view what) {
  throw std::invalid_argument(fmt::format("{}:{}: {}", file.string(), line, what));
}

}  // namespace

std::vector<double> read_number_column(const std::filesystem::path& file) {
  if (std::filesystem::is_directory(file)) {
    throw std::invalid_argument(file.string() +
                                " is a folder; a CSV file with one number on each line is accepted");
  }
  std::ifstream in(file, std::ios::binary);
  if (!in)
    throw std::invalid_argument(file.string() + ": cannot be opened: no such file, or no right to read it");
  std::vector<double> numbers;
  std::string row;
  int line = 0, blank = 0;  // blank: the first blank line since the last number
  while (std::getline(in, row)) {
    ++line;
    std::string_view text = row;
    if (line == 1 && text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
    text = unquote(trim(text));
    if (text.empty()) {
      if (blank == 0) blank = line;
      continue;
    }
    if (blank > 0) refuse(file, blank, "the line is blank; a number is accepted");
    const auto value = to_number(text);
    if (value) {
      numbers.push_back(*value);
    } else if (text.find_first_of(",;\t") != std::string_view::npos) {
      refuse(file, line,
             fmt::format("'{}' is more than one column, or a number with a decimal comma; one column "
                         "of numbers with a decimal point is accepted",
                         text.substr(0, 60)));
    } else if (line > 1 || !is_header(text)) {
      refuse(file, line,
             fmt::format("'{}' is no finite number; a number such as -0.25 is accepted", text.substr(0, 60)));
    }
  }
  if (in.bad()) throw std::system_error(std::make_error_code(std::errc::io_error), file.string());
  if (numbers.empty())
    throw std::invalid_argument(file.string() + ": no numbers; one on each line is accepted");
  return numbers;
}

}  // namespace palpate::app
