#pragma once

#include <string_view>

#include "base/text/enum_words.hpp"

namespace palpate::sim {

/// How a cycle ended. NotFinite: a displacement of a probe or a force is no number.
enum class Stop { Converged, SingularMatrix, NotFinite };

inline constexpr base::EnumWords<Stop, 3> kStopWords{{{Stop::Converged, "converged"},
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
};

}  // namespace palpate::sim
