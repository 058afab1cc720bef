#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace palpate::base {

/// What the JSON library says, without its own name: "[json.exception.type_error.302] type must be number,
/// but is string" gives "type must be number, but is string".
std::string json_words(std::string_view what);

/// The same for a text that it cannot parse, with the word that is none of JSON: "no JSON at character 7:
/// 'NaN' ...".
/// @param byte  where the library stopped, from 1 on
std::string json_words(std::string_view what, std::string_view text, std::size_t byte);

}  // namespace palpate::base
