#pragma once

namespace palpate::analysis {

/// The answers of one examinee under one cell.
struct ExamineeCount {
  long correct = 0;
  long trials = 0;
};

/// The difference of two proportions correct, of a and b of at least one trial each: one quotient of whole
/// numbers, so that equal differences are equal to the last bit and differences of 0 are 0, whatever the
/// numbers of trials.
inline double proportion_difference(const ExamineeCount& a, const ExamineeCount& b) {
  return static_cast<double>(a.correct * b.trials - b.correct * a.trials) /
         static_cast<double>(a.trials * b.trials);
}

}  // namespace palpate::analysis
