#pragma once

#include <span>
#include <string_view>
#include <vector>

namespace palpate::analysis {

// p values of several tests, adjusted so that each may be held against alpha by itself. They stay in their
// order; each function throws std::invalid_argument unless all lie between 0 and 1 and there is one at least.

/// Keeps the probability of any false rejection at alpha, whatever the tests' dependence. Source: [Holm1979].
std::vector<double> holm(std::span<const double> p);

/// The same, stronger, for tests that are independent or positively dependent. Source: [Hochberg1988].
std::vector<double> hochberg(std::span<const double> p);

/// Keeps the expected share of false ones among the rejections at alpha, for tests that are independent or
/// positively dependent. Source: [BenjaminiHochberg1995].
std::vector<double> benjamini_hochberg(std::span<const double> p);

/// By the name that a protocol gives: "holm", "hochberg", "benjamini-hochberg"; "none" leaves them as they
/// are. Throws std::invalid_argument for another name.
std::vector<double> adjusted(std::string_view method, std::span<const double> p);

}  // namespace palpate::analysis
