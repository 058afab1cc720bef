#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "sim/cycle/simulation.hpp"
#include "sim/model/model.hpp"

namespace palpate::sim {

/// Of a sample of times [us].
struct Percentiles {
  double median = 0.0;
  double p99 = 0.0;
  double p999 = 0.0;
  double slowest = 0.0;
};

/// Smallest time that at least the given share of the sample does not exceed. Throws std::invalid_argument
/// for an empty sample.
Percentiles percentiles_of(std::vector<double> microseconds);

/// Time of one haptic cycle under one contact model, over the poses at which bodies touch.
struct CycleCost {
  std::string_view law{};               // its name
  std::vector<double> depths{};         // of the poses [m]
  std::vector<double> depth_medians{};  // of the whole cycle at each of them [us]
  std::vector<double>
      depth_p999{};           // likewise, of it and its 4 neighbours on each side: one has too few cycles
  bool touching = false;      // false: no pose of the press brings bodies together
  int active = 0;             // (node, polygon) pairs at the deepest pose
  int cycles = 0;             // that were timed
  long interruptions = 0;     // meanwhile, by other programs: they are in the slowest times
  Percentiles deformation{};  // by the probes alone: the same cycle without contact
  Percentiles interaction{};  // detection and contact: the rest of the cycle
  Percentiles total{};
  double limit = 0.0;           // median time to read the final contact set's compliance once [us]
  std::size_t limit_bytes = 0;  // of it
};

/// Which cycles are timed.
struct CycleSampling {
  double depth = 0.0;       // of the deepest pose [m], > 0
  int poses = 64;           // equal steps to the depth; those at which nothing touches are left out
  int most_cycles = 20000;  // the 99.9th percentile needs some thousands
  double most_seconds = 2.0;
};

/// Presses to and fro over the poses and times each cycle, after one round to warm up. Each cycle is timed
/// beside one without contact at the same pose, and their difference is the interaction. The probes move a
/// whole step from cycle to cycle, faster than a hand would at 1 kHz, so less is left from the cycle before.
CycleCost measure_cycle(const Model& model, const ContactLaw& law, const CycleSampling& sampling);

/// The compliance that the last cycle could not do without: of every node that carries load, the column of
/// C_TT (what can touch must be moved by it); of every probe that presses, its own columns.
struct ContactSet {
  struct Columns {
    const Eigen::MatrixXd* matrix = nullptr;
    Eigen::Index first = 0, count = 0;
  };
  std::vector<Columns> columns{};
  std::size_t bytes = 0;
};
ContactSet final_contact_set(const Model& model, ProbeDisplacements probes, const Loads& loads);

/// Reads all of it once. @return its sum, so that the reading is not optimised away
double read_once(const ContactSet& set);

}  // namespace palpate::sim
