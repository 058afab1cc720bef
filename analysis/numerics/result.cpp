#include "analysis/numerics/result.hpp"

#include <fmt/core.h>

#include <cmath>
#include <stdexcept>

#include "base/text/counted.hpp"

namespace palpate::analysis {

Side side_from_name(std::string_view name) {
  if (name == "greater") return Side::Greater;
  if (name == "less") return Side::Less;
  if (name == "two-sided") return Side::TwoSided;
  throw std::invalid_argument(fmt::format("side is '{}'; accepted: greater, less, two-sided", name));
}

std::string_view name_of(Side side) {
  switch (side) {
    case Side::Greater:
      return "greater";
    case Side::Less:
      return "less";
    case Side::TwoSided:
      break;
  }
  return "two-sided";
}

double PValues::of(Side side) const {
  switch (side) {
    case Side::Greater:
      return greater;
    case Side::Less:
      return less;
    case Side::TwoSided:
      break;
  }
  return two_sided;
}

void require_level(double level, std::string_view name) {
  if (level > 0 && level < 1) return;
  throw std::invalid_argument(
      fmt::format("{} is {}; it must lie between 0 and 1, both excluded", name, level));
}

void require_counts(long correct, long trials) {
  if (trials < 1) throw std::invalid_argument(fmt::format("{} trials; at least 1 is needed", trials));
  if (correct >= 0 && correct <= trials) return;
  throw std::invalid_argument(fmt::format("{} of {}; accepted: 0 to {}",
                                          base::counted(correct, "correct answer", "correct answers"),
                                          base::counted(trials, "trial", "trials"), trials));
}

void require_finite(double value, std::string_view name) {
  if (std::isfinite(value)) return;
  throw std::invalid_argument(fmt::format("{} is {}; it must be a finite number", name, value));
}

}  // namespace palpate::analysis
