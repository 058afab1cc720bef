#pragma once

#include "analysis/binomial/critical_number.hpp"
#include "analysis/numerics/result.hpp"

namespace palpate::analysis {

/// The proportion of discriminators p_d = (p − chance)/(1 − chance): those who would not have to guess.
double discriminators_at(double proportion, double chance);
double proportion_at(double discriminators, double chance);

struct SimilarityTest {
  long correct = 0, trials = 0;
  double chance = 1.0 / 3;
  double bound = 0.5;                 // proportion correct from which on things are no longer similar
  double bound_discriminators = 0.0;  // the same as a proportion of discriminators
  double alpha = 0.05;                // largest probability of a false claim of similarity
  double proportion = 0.0;
  double discriminators = 0.0;        // estimate; 0 at chance and below
  double discriminators_up_to = 1.0;  // upper one-sided exact bound at 1 - alpha
  double p = 1.0;                     // of so few correct answers or fewer at the bound
  bool similar = false;               // p <= alpha
  CriticalNumber critical{};     // at_most: similar up to this many; size: of a false claim, at the bound
  double power_at_chance = 0.0;  // of claiming similarity when everybody guesses
  Method method{};
};

/// Equivalence test for forced choices: whether the proportion correct lies below `bound`, between chance
/// and 1. The hypothesis to be rejected is that it is at least `bound`: exact binomial, lower tail. What ISO
/// 4120 (triangle), ISO 5495 (paired comparison) and ISO 10399 (duo-trio) call a test for similarity, whose
/// risk beta is `alpha` here. Source: [ISO4120]. Throws std::invalid_argument unless chance < bound < 1.
SimilarityTest similarity_test(long correct, long trials, double chance, double bound, double alpha);

}  // namespace palpate::analysis
