#pragma once

#include <cstdint>
#include <optional>
#include <random>
#include <span>
#include <string>
#include <vector>

#include "sim/mesh/tet_mesh.hpp"

namespace palpate::hard_cases {

using sim::TetMesh;
using sim::Vec3;

/// Seeded disturbance of the numbers that a case is made of: each by a part of itself that is log-uniform in
/// 1e-9 .. 1e-3, up or down. The exact run, number 0, changes nothing.
class Jitter {
 public:
  explicit Jitter(int run) : run_(run), random_(static_cast<std::uint64_t>(run)) {}

  bool exact() const { return run_ == 0; }
  std::uint64_t seed() const { return static_cast<std::uint64_t>(run_); }  // for a case's own random numbers

  /// A part of a value: 0 in the exact run.
  double part();
  double of(double value) { return value * (1.0 + part()); }
  Vec3 of(const Vec3& value) { return {of(value[0]), of(value[1]), of(value[2])}; }
  /// Every node moved along every axis by a part of `size` [m].
  TetMesh of(TetMesh mesh, double size);

 private:
  int run_;
  std::mt19937_64 random_;
};

enum class Bound { AtMost, AtLeast };

/// What one run of a case has come to.
struct Outcome {
  double figure = 0.0;  // measured
  double limit = 0.0;   // that it must keep
  Bound bound = Bound::AtMost;
  int checks = 0;                     // of what the case states besides its figure
  std::vector<std::string> faults{};  // those that did not hold, in words; none may
  std::optional<double> kuroda{},
      sibille{};  // the same figure of the laws that the case does not bind: published

  bool holds() const;
  /// Notes a fault where something that the case states besides its figure does not hold.
  void expect(bool holds_here, const std::string& otherwise) {
    ++checks;
    if (!holds_here) faults.push_back(otherwise);
  }
};

/// One case of the catalogue.
struct HardCase {
  int number = 0;
  const char* name = "";       // of its test
  const char* title = "";      // what is hard, in few words
  const char* criterion = "";  // what must hold
  const char* figure = "";     // what is measured, with its unit; empty: checks alone
  const char* binds = "";      // contact models that must keep it; "-": the case is none of contact
  Outcome (*run)(Jitter& jitter) = nullptr;
};

/// A case of what does not exist yet.
struct OpenCase {
  int number = 0;
  const char* title = "";
  const char* criterion = "";
  const char* reason = "";
};

std::span<const HardCase> hard_cases();
std::span<const OpenCase> open_cases();

/// Runs a case once exactly and ten times with jitter.
std::vector<Outcome> run_all(const HardCase& hard_case);

/// The outcome of several runs: the figure that is nearest to its limit or farthest beyond, the largest published
/// ones, all faults.
Outcome worst(std::span<const Outcome> outcomes);

}  // namespace palpate::hard_cases
