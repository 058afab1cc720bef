#pragma once

#include <optional>
#include <string_view>

namespace palpate::base {

/// Part k of n of a computation, as `--shard K/N` names it.
struct Shard {
  long k = 1, n = 1;

  bool operator==(const Shard&) const = default;
};

/// "2/4" -> {2, 4}; nothing unless both are whole numbers and 1 <= k <= n.
std::optional<Shard> parse_shard(std::string_view text);

}  // namespace palpate::base
