#pragma once

#include <cstdint>

#include "analysis/report/study_table.hpp"

namespace palpate::analysis {

/// How often a study finds a true effect.
struct Power {
  double probability = 0.0;     // of a correct answer, for every examinee or on the average
  double overdispersion = 0.0;  // gamma, 0 to 1: how unlike examinees are
  double power = 0.0;
  double standard_error = 0.0;  // of the simulation; 0: exact
  long studies = 0;             // simulated; 0: exact
};

/// Power of the protocol's primary test in one cell at the planned sample, planned looks included, when an
/// examinee's answers are right with a probability of his own: beta-distributed with the mean `probability`
/// and the overdispersion gamma = 1/(a + b + 1), 0 for examinees all alike [Brockhoff2003]. Exact for coin
/// flips. For balanced orders the region of rejection depends on the answers: then 10 000 simulated studies,
/// seeded. Throws std::invalid_argument unless 0 < probability < 1, 0 <= overdispersion < 1, and the design
/// fixes the number of trials. Where the protocol adjusts the cells' p values, it is the power if no other cell
/// rejects: the least that the adjustment leaves.
Power primary_power(const StudyDesign& design, double probability, double overdispersion = 0.0,
                    std::uint64_t seed = 1);

}  // namespace palpate::analysis
