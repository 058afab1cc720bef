#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "analysis/binomial/critical_number.hpp"

namespace palpate::analysis {

/// How much of alpha may have been spent when a share t of the planned sample is in [LanDeMets1983].
enum class Spending {
  OBrienFleming,  // 2 - 2 Phi(z(1 - alpha/2)/sqrt(t)): hardly anything early
  Pocock          // alpha ln(1 + (e - 1) t): evenly
};

/// "obrien-fleming" or "pocock"; anything else is a std::invalid_argument.
Spending spending_from_name(std::string_view name);
std::string_view name_of(Spending spending);

/// Alpha that may have been spent at a share `t` of the sample, 0 < t <= 1.
double spent(Spending spending, double alpha, double t);

/// A look at the answers that the protocol plans.
struct PlannedLook {
  CriticalNumber critical{};  // for the trials that are in at this look; `alpha` is what may have been spent
  double size = 0.0;  // probability that guessing has been rejected at this look or before, <= alpha spent
};

/// Critical numbers of the exact binomial test at several looks, so that guessers are rejected at any of them
/// with a probability of at most alpha. At each look the smallest number whose probability, together with
/// what earlier looks have used, stays within what may have been spent; alpha that the discrete steps leave
/// unspent is carried on. Exact, by the distribution of the number correct among those not yet rejected.
/// One-sided: greater or less. Throws std::invalid_argument unless trials ascend, side is one-sided, and
/// alpha and chance lie between 0 and 1.
/// @param trials  answers that are in at each look; the last is the whole sample
std::vector<PlannedLook> planned_looks(std::span<const long> trials, double chance, double alpha, Side side,
                                       Spending spending);

}  // namespace palpate::analysis
