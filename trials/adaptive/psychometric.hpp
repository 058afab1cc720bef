#pragma once

#include "base/text/enum_words.hpp"

namespace palpate::trials {

/// How the share of correct answers grows with the level, from the guess rate up to 1 less the lapse rate.
enum class PsychometricFunction { WeibullDb, Normal, Logistic };
inline constexpr base::EnumWords<PsychometricFunction, 3> kFunctionWords{
    {{PsychometricFunction::WeibullDb, "weibull_db", "Weibull's function of levels in dB"},
     {PsychometricFunction::Normal, "normal", "the cumulative normal distribution"},
     {PsychometricFunction::Logistic, "logistic", "the logistic function"}}};

struct PsychometricParameters {
  double threshold = 0.0;           // t, in the unit of the level x
  double slope = 1.0;               // b > 0: of weibull_db without a unit, else per unit of the level
  double guess = 0.0, lapse = 0.0;  // shares, together < 1
};

/// psi(x) = guess + (1 - guess - lapse) F(x), with F(x) = 1 - exp(-10^(b (x - t) / 20)) [Watson2017],
/// x and t in dB, Phi(b (x - t)), or 1 / (1 + exp(-b (x - t))).
double share_correct(PsychometricFunction function, double level, const PsychometricParameters& parameters);

/// The uncertainty of a yes or no [bit]: -p log2 p - (1 - p) log2 (1 - p).
double binary_entropy(double p);

}  // namespace palpate::trials
