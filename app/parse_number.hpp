#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace palpate::app {

// Numbers as people write them after an option. Each throws std::invalid_argument that names the option.

/// "0.5" or "1/2".
double parse_fraction(std::string_view option, const std::string& text);

/// "794,86,150,570": whole numbers, `count` of them.
std::vector<long> parse_counts(std::string_view option, const std::string& text, std::size_t count);

}  // namespace palpate::app
