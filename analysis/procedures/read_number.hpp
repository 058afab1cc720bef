#pragma once

#include <optional>
#include <string_view>

namespace palpate::analysis {

// The whole of a text as a number, whatever the locale: nothing before or behind it. Empty where it is none.

std::optional<long> read_count(std::string_view text);       // "60"
std::optional<double> read_finite(std::string_view text);    // "-0.25", "+3e-2"; not "nan", "inf"
std::optional<double> read_fraction(std::string_view text);  // "1/2" or "0.5"

}  // namespace palpate::analysis
