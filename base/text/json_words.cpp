#include "base/text/json_words.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace palpate::base {
namespace {

bool is_of_word(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-' ||
         c == '.';
}

/// The word of letters that holds a place; "" where there is none.
std::string_view word_at(std::string_view text, std::size_t place) {
  if (place >= text.size() || !is_of_word(text[place])) return "";
  std::size_t first = place, end = place;
  while (first > 0 && is_of_word(text[first - 1])) --first;
  while (end < text.size() && is_of_word(text[end])) ++end;
  return text.substr(first, std::min<std::size_t>(end - first, 40));
}

}  // namespace

std::string json_words(std::string_view what) {
  const std::size_t end = what.find("] ");
  if (what.starts_with("[json.exception.") && end != std::string_view::npos) what.remove_prefix(end + 2);
  return std::string(what);
}

std::string json_words(std::string_view what, std::string_view text, std::size_t byte) {
  const std::string_view word = byte > 0 ? word_at(text, byte - 1) : "";
  if (!word.empty())
    return fmt::format(
        "no JSON at character {}: '{}'; accepted: finite numbers such as 0.5, texts in double quotes, true, "
        "false, null, [..] and {{..}}",
        byte, word);
  const std::string said = json_words(what);
  const std::size_t colon = said.find(": ");  // "parse error at line 1, column 7: ..."
  return fmt::format("no JSON at character {}: {}", byte,
                     colon == std::string::npos ? said : said.substr(colon + 2));
}

}  // namespace palpate::base
