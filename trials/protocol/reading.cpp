#include "trials/protocol/reading.hpp"

#include <fmt/ranges.h>

#include <algorithm>

namespace palpate::trials {

std::string word(base::TomlReader& reader, std::string_view key, std::span<const std::string_view> accepted,
                 std::span<const std::string_view> later) {
  reader.required(key, fmt::format("accepted: {}", fmt::join(accepted, ", ")));
  std::string found = *reader.text(key);
  if (std::ranges::find(accepted, found) != accepted.end()) return found;
  const bool known = std::ranges::find(later, found) != later.end();
  reader.refuse(key, fmt::format("found \"{}\"{}, accepted: {}", found,
                                 known ? ", which is not in this version" : "", fmt::join(accepted, ", ")));
}

int whole_number(base::TomlReader& reader, std::string_view key, std::int64_t least, std::int64_t most) {
  reader.required(key, fmt::format("accepted: a whole number from {} to {}", least, most));
  const std::int64_t found = *reader.integer(key);
  if (found < least || found > most)
    reader.refuse(key, fmt::format("found {}, accepted: a whole number from {} to {}", found, least, most));
  return static_cast<int>(found);
}

std::size_t condition_index(base::TomlReader& reader, std::string_view key, const Protocol& protocol,
                            const std::string& name) {
  const auto found = std::ranges::find(protocol.conditions, name, &Condition::name);
  if (found != protocol.conditions.end()) return found - protocol.conditions.begin();
  std::vector<std::string> names;
  for (const Condition& condition : protocol.conditions) names.push_back(condition.name);
  reader.refuse(key, fmt::format("\"{}\" is no condition of this protocol; accepted: {}", name,
                                 fmt::join(names, ", ")));
}

}  // namespace palpate::trials
