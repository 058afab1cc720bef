#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>

#include "base/text/enum_words.hpp"
#include "base/text/toml_reader.hpp"
#include "trials/protocol/protocol.hpp"

namespace palpate::trials {

/// What the readers of a protocol's tables share. All throw std::invalid_argument as TomlReader::refuse().

/// One word of `accepted`; words of `later` are known to the design but not to this version.
std::string word(base::TomlReader& reader, std::string_view key, std::span<const std::string_view> accepted,
                 std::span<const std::string_view> later = {});

/// The value that one of the words stands for.
template <class Enum, std::size_t count>
Enum word(base::TomlReader& reader, std::string_view key, const base::EnumWords<Enum, count>& words,
          std::span<const std::string_view> later = {}) {
  std::vector<std::string_view> accepted;
  for (const base::EnumWord<Enum>& known : words) accepted.push_back(known.word);
  return *base::value_of(words, word(reader, key, accepted, later));
}

int whole_number(base::TomlReader& reader, std::string_view key, std::int64_t least, std::int64_t most);

/// Index into Protocol::conditions.
std::size_t condition_index(base::TomlReader& reader, std::string_view key, const Protocol& protocol,
                            const std::string& name);

}  // namespace palpate::trials
