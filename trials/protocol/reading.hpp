#pragma once

#include <fmt/format.h>

#include <string>
#include <string_view>

#include "base/text/toml_reader.hpp"
#include "trials/protocol/protocol.hpp"

namespace palpate::trials {

/// Index into Protocol::conditions of the one that a key names. Throws std::invalid_argument as
/// TomlReader::refuse().
std::size_t condition_index(const base::TomlReader& reader, std::string_view key, const Protocol& protocol,
                            const std::string& name);

}  // namespace palpate::trials
