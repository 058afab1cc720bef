#pragma once

#include <optional>
#include <span>

#include "analysis/numerics/examinee_count.hpp"
#include "analysis/numerics/result.hpp"

namespace palpate::analysis {

/// Interval for the proportion correct of all examinees together that takes examinees, not answers, for
/// independent: whole examinees are drawn anew with replacement [EfronTibshirani1993], which is what a
/// cluster bootstrap is. 9999 resamples, fewer (999 at least) where more than 2e7 draws would be needed.
/// Empty for fewer than two examinees with answers, or where all have the same proportion correct: then the
/// draws cannot differ.
std::optional<Interval> interval_over_examinees(std::span<const ExamineeCount> examinees, double level);

}  // namespace palpate::analysis
