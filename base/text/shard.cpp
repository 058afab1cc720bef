#include "base/text/shard.hpp"

#include <charconv>

namespace palpate::base {
namespace {

/// A whole number; 0 for text that is none.
long whole_number(std::string_view text) {
  long value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size() ? value : 0;
}

}  // namespace

std::optional<Shard> parse_shard(std::string_view text) {
  const std::size_t slash = text.find('/');
  if (slash == std::string_view::npos) return std::nullopt;
  const Shard shard{whole_number(text.substr(0, slash)), whole_number(text.substr(slash + 1))};
  return 1 <= shard.k && shard.k <= shard.n ? std::optional(shard) : std::nullopt;
}

}  // namespace palpate::base
