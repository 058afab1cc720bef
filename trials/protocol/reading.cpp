#include "trials/protocol/reading.hpp"

#include <fmt/ranges.h>

#include <algorithm>

namespace palpate::trials {

std::size_t condition_index(const base::TomlReader& reader, std::string_view key, const Protocol& protocol,
                            const std::string& name) {
  const auto found = std::ranges::find(protocol.conditions, name, &Condition::name);
  if (found != protocol.conditions.end()) return found - protocol.conditions.begin();
  std::vector<std::string> names;
  for (const Condition& condition : protocol.conditions) names.push_back(condition.name);
  reader.refuse(key, fmt::format("\"{}\" is no condition of this protocol; accepted: {}", name,
                                 fmt::join(names, ", ")));
}

}  // namespace palpate::trials
