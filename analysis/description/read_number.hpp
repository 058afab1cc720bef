#pragma once

#include <optional>
#include <string_view>

namespace palpate::analysis {

// The whole of a text as a number, whatever the locale: nothing before or behind it. Empty where it is none.

/// A result is made of squares and of their sums: beyond these bounds they are no numbers, or 0, any more,
/// and beyond this count Boost's distributions are none.
constexpr double kLeastMagnitude = 1e-150, kMostMagnitude = 1e150;
constexpr long kMostCount = 1'000'000'000;
inline constexpr std::string_view kMagnitudeBounds = "0, or of magnitude 1e-150 to 1e150";
inline constexpr std::string_view kCountBounds = "from 0 to 1000000000";

std::optional<long> read_count(std::string_view text);       // "60"; within kCountBounds
std::optional<long> read_seed(std::string_view text);        // the same without an upper bound
std::optional<double> read_number(std::string_view text);    // "-0.25", "+3e-2"; within kMagnitudeBounds
std::optional<double> read_fraction(std::string_view text);  // "1/2" or "0.5"; within kMagnitudeBounds
/// The same as small as it comes: a p value may be 1e-200 and is not squared.
std::optional<double> read_finite(std::string_view text);

/// Whether the text is meant as a number, be it one that is too large for any use: "1e999".
bool is_numeral(std::string_view text);

}  // namespace palpate::analysis
