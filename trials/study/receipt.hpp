#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace palpate::trials {

/// Where the hash chain stands: printed as a receipt at a session's end, "120-9f86d0...".
struct Receipt {
  std::int64_t entries = 0;
  std::string head{};  // 64 hexadecimal digits; the first 16 or more, in one read from paper

  bool operator==(const Receipt&) const = default;
};
std::string to_string(const Receipt& receipt);
/// Reads one that was printed or written down by hand: 16 or more of the head's digits, in any case, with
/// spaces around. Throws std::invalid_argument.
Receipt parse_receipt(std::string_view text);

}  // namespace palpate::trials
