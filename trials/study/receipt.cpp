#include "trials/study/receipt.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <stdexcept>

namespace palpate::trials {

std::string to_string(const Receipt& receipt) {
  return fmt::format("{}-{}", receipt.entries, receipt.head);
}

Receipt parse_receipt(std::string_view as_given) {
  constexpr std::string_view kSpaces = " \t\r\n";
  constexpr std::size_t kFewestDigits = 16, kDigits = 64;  // 64 bits are enough against chance
  const std::size_t first = std::min(as_given.find_first_not_of(kSpaces), as_given.size());
  const std::string_view text = as_given.substr(first, as_given.find_last_not_of(kSpaces) + 1 - first);
  const auto dash = text.find('-');
  const std::string_view count = text.substr(0, dash);
  Receipt receipt;
  const auto read = std::from_chars(count.data(), count.data() + count.size(), receipt.entries);
  if (dash != std::string_view::npos) receipt.head = text.substr(dash + 1);
  for (char& c : receipt.head)
    if (c >= 'A' && c <= 'F') c = static_cast<char>(c - 'A' + 'a');
  const bool hexadecimal = receipt.head.find_first_not_of("0123456789abcdef") == std::string::npos;
  if (read.ec != std::errc() || read.ptr != count.data() + count.size() || receipt.entries < 0 ||
      receipt.head.size() < kFewestDigits || receipt.head.size() > kDigits || !hexadecimal)
    throw std::invalid_argument(
        fmt::format("receipt: found \"{}\", accepted: a number, a hyphen and {} hexadecimal digits, or the "
                    "first {} of them or more, as printed at a session's end",
                    as_given, kDigits, kFewestDigits));
  return receipt;
}

}  // namespace palpate::trials
