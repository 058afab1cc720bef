#include "trials/adaptive/psychometric.hpp"

#include <cmath>
#include <numbers>

namespace palpate::trials {
namespace {

double sensed_share(PsychometricFunction function, double distance, double slope) {
  switch (function) {
    case PsychometricFunction::WeibullDb:
      return -std::expm1(-std::pow(10.0, slope * distance / 20.0));
    case PsychometricFunction::Normal:
      return 0.5 * std::erfc(-slope * distance / std::numbers::sqrt2);
    case PsychometricFunction::Logistic:
      return 1.0 / (1.0 + std::exp(-slope * distance));
  }
  return 0.0;
}

}  // namespace

double share_correct(PsychometricFunction function, double level, const PsychometricParameters& parameters) {
  return parameters.guess + (1.0 - parameters.guess - parameters.lapse) *
                                sensed_share(function, level - parameters.threshold, parameters.slope);
}

double binary_entropy(double p) {
  const auto part = [](double share) { return share > 0.0 ? -share * std::log2(share) : 0.0; };
  return part(p) + part(1.0 - p);
}

}  // namespace palpate::trials
