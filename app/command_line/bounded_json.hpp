#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace palpate::app {

/// Parses JSON from outside. Throws std::invalid_argument where brackets are deeper than any input of ours, which
/// would overflow the stack of whoever copies the value or writes it out; where a key is there twice; and where it
/// is no JSON, with the place.
nlohmann::ordered_json parse_bounded_json(const std::string& text);

}  // namespace palpate::app
