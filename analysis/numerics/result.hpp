#pragma once

#include <string>
#include <string_view>

namespace palpate::analysis {

// The parts that the results of the tests have in common.

/// The alternative hypothesis. It is decided before the data are seen: no function here chooses it.
enum class Side { Greater, Less, TwoSided };

/// "greater", "less" or "two-sided"; anything else is a std::invalid_argument that lists the three.
Side side_from_name(std::string_view name);
std::string_view name_of(Side side);

struct PValues {
  double greater = 1.0;    // against "more than the hypothesis says"
  double less = 1.0;       // against "fewer"
  double two_sided = 1.0;  // against "other"
  double of(Side side) const;
};

/// An interval with the confidence that its method promises. An end that the data leave open is infinite.
struct Interval {
  double lower = 0.0;
  double upper = 0.0;
  double level = 0.95;  // confidence, 0 < level < 1
  std::string method{};
};

/// How a result was come by, for the reader of a report.
struct Method {
  std::string name{};    // "exact binomial test"
  std::string source{};  // "Clopper & Pearson 1934"
};

// Promises that many functions ask of their callers; each throws std::invalid_argument with the value found.
void require_level(double level, std::string_view name);  // 0 < level < 1
void require_counts(long correct, long trials);           // 0 <= correct <= trials, trials >= 1
void require_finite(double value, std::string_view name);

}  // namespace palpate::analysis
