#pragma once

#include "analysis/detection/choice_task.hpp"
#include "analysis/numerics/result.hpp"

namespace palpate::analysis {

/// What is done about proportions of 0 and 1, whose d' would be infinite.
enum class DPrimeCorrection {
  None,       // infinite is reported as infinite
  HalfTrial,  // 0 and 1 only: 1/(2n) and 1 - 1/(2n)   [MacmillanKaplan1985]
  LogLinear   // always: (k + 1/2)/(n + 1)             [Hautus1995]
};

/// "none", "half-trial" or "log-linear"; anything else is a std::invalid_argument.
DPrimeCorrection correction_from_name(std::string_view name);
std::string_view name_of(DPrimeCorrection correction);

/// What a method's source says about it: "; at 0 and 100 % corrected by ..."
std::string source_of(DPrimeCorrection correction);

/// The proportion that enters z, after the correction.
double corrected_proportion(long correct, long trials, DPrimeCorrection correction);

struct DPrime {
  ChoiceTask task{};
  long correct = 0;
  long trials = 0;
  double proportion = 0.5;  // that entered z, corrected
  bool corrected = false;   // whether the correction changed it
  DPrimeCorrection correction = DPrimeCorrection::HalfTrial;
  double d_prime = 0.0;
  double standard_error = 0.0;  // by the delta method; infinite where d_prime is
  Interval interval{};          // of the exact interval for the proportion, uncorrected; ends may be infinite
  Method method{};
};

/// Sensitivity of an unbiased observer from the correct answers of a choice task: the d' whose proportion
/// correct is the one seen, corrected as asked (see proportion_correct for the models and their sources).
/// Where a task knows no direction, d' is 0 at chance and below; its standard error is then infinite. There
/// the interval starts at 0, and is empty (both ends NaN) when even its upper end lies below chance. Throws
/// std::invalid_argument for counts or levels that cannot be.
DPrime dprime(const ChoiceTask& task, long correct, long trials, DPrimeCorrection correction,
              double level = 0.95);

/// Sensitivity of an unbiased observer in a two-interval forced choice: d' = sqrt(2) z(proportion correct),
/// the distance of the two conditions in standard deviations of one interval's noise. Negative below 50 %.
/// Sources: [MacmillanCreelman2005] ch. 7, [HackerRatcliff1979] table for m = 2.
DPrime dprime_2ifc(long correct, long trials, DPrimeCorrection correction, double level = 0.95);

/// The same without the assumption of no bias, from the hit rates of the two orders: d' = (z(H1) +
/// z(H2))/sqrt(2), c = (z(H2) - z(H1))/2: below 0 the first interval is favoured.
struct DPrimeByOrder {
  double d_prime = 0.0;
  double standard_error = 0.0;  // by the delta method; infinite where d_prime is
  Interval interval{};          // by profile likelihood of the uncorrected counts; ends may be infinite
  double criterion = 0.0;
  bool corrected = false;
  DPrimeCorrection correction = DPrimeCorrection::HalfTrial;
  Method method{};
};
DPrimeByOrder dprime_2ifc_by_order(long correct_first, long trials_first, long correct_second,
                                   long trials_second, DPrimeCorrection correction, double level = 0.95);

}  // namespace palpate::analysis
