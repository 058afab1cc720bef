#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace palpate::base {

/// Bytes of the UTF-8 character that `text` begins with, 1 to 4; 0 where it begins with none (RFC 3629: no
/// overlong forms, no surrogates, nothing beyond U+10FFFF). @param text  not empty
std::size_t utf8_length(std::string_view text);

/// A foreign text made fit for a message: control characters and bytes that are no UTF-8 as "\\x1b", cut after
/// 200 characters.
std::string printable(std::string_view text);

/// Whether all of `text` is UTF-8.
bool is_utf8(std::string_view text);

}  // namespace palpate::base
