#pragma once

#include <chrono>
#include <cstddef>
#include <vector>

#include "sim/cost/cycle_cost.hpp"
#include "sim/cycle/simulation.hpp"
#include "sim/model/model.hpp"

namespace palpate::sim {

using CycleClock = std::chrono::steady_clock;

inline double microseconds_since(CycleClock::time_point start) {
  return std::chrono::duration<double, std::micro>(CycleClock::now() - start).count();
}

/// One of the poses that are timed.
struct PressPose {
  double depth = 0.0;  // [m]
  std::vector<ProbeDisplacement> probes{};
};

/// From shallow to deep: those at which bodies touch, or all if there are none of these.
/// @param alone  a simulation of the model without contact
std::vector<PressPose> poses_to_time(const Model& model, const CycleSampling& sampling, Simulation& alone,
                                     bool& touching);

/// There and back: 0, 1, ..., n - 1, n - 2, ..., 1, and again.
std::size_t to_and_fro(int cycle_number, std::size_t poses);

/// The model under another contact law.
Model with_law(Model model, const ContactLaw& law);

}  // namespace palpate::sim
