#pragma once

#include <cstdint>
#include <vector>

#include "trials/observer/observer.hpp"
#include "trials/protocol/stimuli.hpp"

namespace palpate::trials {

/// Answers of one sitting in one cell, counted.
struct SittingCount {
  long trials = 0;
  long correct_first = 0;  // trials with the correct condition in the first interval
  long answers_first = 0;  // trials answered with the first interval
  long correct = 0;
};

/// The seed of study number `study` of many that are drawn from one seed.
std::uint64_t seed_of_study(std::uint64_t seed, long study);

/// A whole study played and counted, nothing stored: the same orders, people, hands and answers that
/// simulate() with the same seed puts into a study file. counts[cell][examinee].
std::vector<std::vector<SittingCount>> play_study(const Protocol& protocol, const Stimuli& stimuli,
                                                  const ObserverParameters& observer, std::uint64_t seed);

}  // namespace palpate::trials
