#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace palpate::base {

/// The most parts of a dotted key or header, and the most brackets within each other. What is deeper would
/// overflow the stack of whoever walks through the tables: a parser, a destructor.
constexpr std::size_t kDeepestKey = 64;
constexpr std::size_t kDeepestBrackets = 64;

/// Throws std::invalid_argument with file and line where a TOML text has a key of more than kDeepestKey parts
/// or more than kDeepestBrackets open brackets. What else is wrong with it is left to the parser.
void refuse_deep_toml(std::string_view text, const std::string& file);

/// The same for a key alone, as the command line takes it: throws where it has more than kDeepestKey parts.
void refuse_deep_key(std::string_view key);

}  // namespace palpate::base
