#pragma once

#include <memory>
#include <vector>

#include "sim/cost/cycle_cost.hpp"
#include "sim/cycle/press.hpp"
#include "tests/bench/rows.hpp"

namespace palpate::bench {

/// A row made ready to be timed, and its times.
class Runner {
 public:
  /// Compiles the row's scene. Throws std::runtime_error where a cycle cannot be solved, or where bodies that a law
  /// keeps apart do not touch.
  explicit Runner(const Row& row);

  /// The press or stroke to and fro, its end alone, and the limit: adds one to each of `cycles`, `ends` and `reads`.
  void take_turn();

  const Row& row() const { return row_; }
  double nodes() const;  // of all bodies
  int contacts() const { return contacts_; }
  long allocations() const { return allocations_; }

  std::vector<double> cycles{};  // mean time of a cycle in each turn [us]
  std::vector<double> ends{};    // likewise, of the last poses [us]
  std::vector<double> reads{};   // to read the compliance of the last pose's contact set once, likewise [us]

 private:
  void there_and_back(std::size_t from);
  double time_cycles(std::size_t from, int times);
  double time_reads(int times) const;

  Row row_;
  sim::Model model_;
  std::vector<std::vector<sim::ProbeDisplacement>> poses_;
  sim::Simulation simulation_;
  sim::ContactSet limit_;
  int contacts_ = 0;      // at the full depth
  long allocations_ = 0;  // in a whole press or stroke
  int ways_a_turn_ = 1, ends_a_turn_ = 1, reads_a_turn_ = 1;
};

}  // namespace palpate::bench
