#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/numerics/result.hpp"
#include "base/text/counted.hpp"

namespace palpate::analysis {

// How numbers are written for people. Digits that the data cannot carry are not printed.

/// "p = 0.003", "p = 0.046", "p < 0.0001", "p > 0.999", "p = 1" where it is 1: two significant digits, at
/// least three decimals where p > 0.001.
std::string p_in_words(double p);

/// The same for a column headed "p": "0.046", "< 0.0001".
std::string bare_p(double p);

/// "2026-11-28 10:11:12" of the ISO 8601 "2026-11-28T10:11:12.345Z"; what is no such time stays as it is.
std::string to_the_second(std::string_view utc);

/// What stands in a table where there is no number.
inline const std::string kNotAvailable = "n/a";

/// "41 of 60".
std::string out_of(long correct, long trials);

/// "68.3 %"; "n/a" for NaN.
std::string percent(double proportion);

/// Four significant digits without exponent where that is short: "0.6746", "52", "infinite", "n/a".
std::string number(double value);

/// A fixed number of decimals: "1.57", "-0.42"; "infinite", "n/a".
std::string decimals(double value, int count);

/// "55.0 % to 79.7 %"; "none" where an interval could not be given.
std::string percent_range(const Interval& interval);

/// "0.179 to 1.177", "2.33 and more", "up to 3" or "any value" where ends are open, "none" where no interval
/// could be given; in the unit of the estimate.
std::string range(const Interval& interval);
std::string range(const Interval& interval, const std::function<std::string(double)>& written);

/// "95 %", "99.999 %": a confidence level or a proportion without needless decimals. Only 1 is "100 %".
std::string short_percent(double proportion);

/// How many columns of a terminal a text takes: letters, not bytes.
std::size_t columns(std::string_view text);

/// A paragraph in lines of at most `width` columns, each with its line end; `first` stands before the first
/// of them, `next` before the others.
std::string wrapped(std::string_view text, std::string_view first = "", std::string_view next = "",
                    std::size_t width = 100);

/// "1 answer", "2 answers".
using base::counted;

/// "kuroda", "kuroda and sibille", "a, b and c".
std::string listed(const std::vector<std::string>& items);

/// 1/2, 1/3, ... as a fraction, anything else as a decimal number.
std::string chance_in_words(double chance);

}  // namespace palpate::analysis
