#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace palpate::app {

/// Parses JSON from outside. Throws std::invalid_argument where brackets are deeper than any input of ours:
/// they would overflow the stack of whoever copies the value or writes it out; and nlohmann::json's
/// parse_error where it is no JSON.
nlohmann::ordered_json parse_bounded_json(const std::string& text);

}  // namespace palpate::app
