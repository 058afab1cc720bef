#pragma once

#include <span>

#include "analysis/numerics/result.hpp"
#include "analysis/psychometric/fit.hpp"

namespace palpate::analysis {

/// What an interval is for: measures.hpp says what each means.
enum class Measure { Level, Slope, HalfDistance, Lapse };

/// Profile-likelihood interval: the values for which the greatest log likelihood of any function that has
/// this value lies within chi-squared(1, level)/2 of the greatest of all [VenzonMoolgavkar1988]. `at` is the
/// F = p of Level and Slope. The values about the estimate up to the first that is too unlikely; an end that
/// the answers leave open is infinite (0 where the measure cannot be negative), the lapse rate's ends stay
/// within its bounds. A fit that is a step or flat has its interval too. For a fixed lapse rate the ends are
/// the rate.
Interval profile_interval(const Fitter& fitter, std::span<const double> correct, const PsychometricFit& fit,
                          Measure measure, double at, double level);

/// The greatest log likelihood of a function that has this value of the measure; for the tests.
double profile_log_likelihood(const Fitter& fitter, std::span<const double> correct, Measure measure,
                              double at, double value);

}  // namespace palpate::analysis
