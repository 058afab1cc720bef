#pragma once

#include <limits>
#include <string_view>

#include "base/text/enum_words.hpp"

namespace palpate::sim {

/// How a cycle ended. WithinTolerance: the law stopped early, its bound of the error within contact.tolerance.
/// CapReached: the law stopped at its cap on iterations, with the residual that it reports.
/// NotFinite: a displacement of a probe or a force is no number.
enum class Stop { Converged, WithinTolerance, CapReached, SingularMatrix, NotFinite };

/// Whether the cycle has a result.
constexpr bool solved(Stop stop) {
  return stop == Stop::Converged || stop == Stop::WithinTolerance || stop == Stop::CapReached;
}

inline constexpr base::EnumWords<Stop, 5> kStopWords{{{Stop::Converged, "converged"},
                                                      {Stop::WithinTolerance, "within tolerance"},
                                                      {Stop::CapReached, "iteration cap reached"},
                                                      {Stop::SingularMatrix, "singular matrix"},
                                                      {Stop::NotFinite, "not finite"}}};

constexpr std::string_view to_string(Stop stop) {
  return base::word_of(kStopWords, stop);
}

struct SolveReport {
  Stop stop = Stop::Converged;
  int iterations = 0;
  double residual = 0.0;  // largest error of what contact prescribed, relative to the largest such
                          // displacement; 0 without [-]
  /// The largest that a probe's force can differ from that of the exact solution of the same scene [N]; infinite where
  /// no bound is known.
  double force_error_bound = std::numeric_limits<double>::infinity();
};

}  // namespace palpate::sim
