#include "base/text/toml_depth.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace palpate::base {
namespace {

constexpr std::size_t kShown = 40;  // of a key, in a message

/// Where the string that begins at `at` ends: the place after its closing quotes, or the text's end (of a
/// string on one line: the line's).
std::size_t end_of_string(std::string_view text, std::size_t at) {
  const char quote = text[at];
  const std::string closing(text.substr(at, 3) == std::string(3, quote) ? 3 : 1, quote);
  for (std::size_t i = at + closing.size(); i < text.size(); ++i) {
    if (quote == '"' && text[i] == '\\')
      ++i;
    else if (text.substr(i, closing.size()) == closing)
      return i + closing.size();
    else if (closing.size() == 1 && text[i] == '\n')
      return i;
  }
  return text.size();
}

bool in_bare_key(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-' ||
         c == '+' || static_cast<unsigned char>(c) >= 0x80;
}

/// Dots since the last character that no dotted key holds, and brackets that are open.
struct Depth {
  std::size_t dots = 0, brackets = 0;

  void pass(char c) {
    if (c == '.')
      ++dots;
    else if (!in_bare_key(c) && c != ' ' && c != '\t')
      dots = 0;
    if (c == '[' || c == '{')
      ++brackets;
    else if ((c == ']' || c == '}') && brackets > 0)
      --brackets;
  }
};

}  // namespace

void refuse_deep_toml(std::string_view text, const std::string& file) {
  Depth depth;
  const auto refuse = [&](std::size_t at, std::string_view what, std::size_t most) {
    throw std::invalid_argument(fmt::format("{}:{}: {} than {}; accepted: up to {}", file,
                                            1 + std::ranges::count(text.substr(0, at), '\n'), what, most,
                                            most));
  };
  for (std::size_t i = 0; i < text.size();) {
    if (text[i] == '"' || text[i] == '\'') {
      i = end_of_string(text, i);
      continue;
    }
    if (text[i] == '#') {
      i = std::min(text.find('\n', i), text.size());
      continue;
    }
    depth.pass(text[i]);
    if (depth.dots >= kDeepestKey) refuse(i, "a key of more parts", kDeepestKey);
    if (depth.brackets > kDeepestBrackets) refuse(i, "brackets deeper", kDeepestBrackets);
    ++i;
  }
}

void refuse_deep_key(std::string_view key) {
  if (std::ranges::count(key, '.') < static_cast<std::ptrdiff_t>(kDeepestKey)) return;
  throw std::invalid_argument(fmt::format("the key \"{}...\" has more parts than {}; accepted: up to {}",
                                          key.substr(0, kShown), kDeepestKey, kDeepestKey));
}

}  // namespace palpate::base
