#pragma once

#include <span>

#include "analysis/psychometric/likelihood.hpp"

namespace palpate::analysis {

struct Summit {
  Line line{};
  double log_likelihood = 0.0;
  int iterations = 0;
};

/// Newton's method from `start` uphill to a local maximum with rise > 0 and the lapse rate within its bounds:
/// with the observed information where it is positive definite, else with Fisher's (scoring), each step
/// halved until the likelihood does not fall. Stops where a step promises less than 1e-13, or the function is
/// all but a step or flat; and, given a rival, as soon as it would end where the rival did or below it.
Summit climb(const Design& design, std::span<const double> correct, const Line& start,
             const Summit* rival = nullptr);

}  // namespace palpate::analysis
