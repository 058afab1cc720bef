#include "trials/study/examinee_code.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace palpate::trials {
namespace {

// Not std::isalnum: the locale must not decide which codes are accepted.
bool is_digit(char c) {
  return c >= '0' && c <= '9';
}
bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}
char lower(char c) {
  return (c >= 'A' && c <= 'Z') ? static_cast<char>(c - 'A' + 'a') : c;
}

}  // namespace

void check_examinee_code(std::string_view code) {
  const bool fits = !code.empty() && code.size() <= 32 && code.front() != '-' &&
                    std::ranges::all_of(code, [](char c) { return is_letter(c) || is_digit(c) || c == '-'; });
  if (!fits)
    throw std::invalid_argument(fmt::format(
        "examinee: found \"{}\", accepted: a code of 1 to 32 letters, digits and hyphens that begins "
        "with a letter or digit, such as P01 (never a name)",
        code));
}

std::string normal_form(std::string_view code) {
  std::string normal;
  bool in_number = false;  // past the leading zeros of a number
  for (std::size_t i = 0; i < code.size(); ++i) {
    const char c = code[i];
    if (c == '-') continue;
    const bool number_goes_on = i + 1 < code.size() && is_digit(code[i + 1]);
    if (c == '0' && !in_number && number_goes_on) continue;
    in_number = is_digit(c);
    normal += lower(c);
  }
  return normal;
}

void check_not_near(std::string_view code, std::span<const std::string> known) {
  if (std::ranges::find(known, code) != known.end()) return;
  const auto near = std::ranges::find_if(
      known, [&](const std::string& other) { return normal_form(other) == normal_form(code); });
  if (near != known.end())
    throw std::invalid_argument(fmt::format(
        "examinee: \"{}\" is not in this study but reads like \"{}\", which is; accepted: {}, or a code "
        "that nobody takes for it",
        code, *near, *near));
}

}  // namespace palpate::trials
