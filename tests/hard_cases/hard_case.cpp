#include "tests/hard_cases/hard_case.hpp"

#include <algorithm>
#include <cmath>

namespace palpate::hard_cases {
namespace {

constexpr int kJitteredRuns = 10;
constexpr double kLeastPart = 1e-9, kLargestPart = 1e-3;

void take_larger(std::optional<double>& kept, const std::optional<double>& other) {
  if (other) kept = std::max(kept.value_or(*other), *other);
}

}  // namespace

double Jitter::part() {
  if (exact()) return 0.0;
  std::uniform_real_distribution<double> exponent(std::log(kLeastPart), std::log(kLargestPart));
  const double size = std::exp(exponent(random_));
  return random_() % 2 == 0 ? size : -size;
}

TetMesh Jitter::of(TetMesh mesh, double size) {
  for (Vec3& node : mesh.nodes) node += size * Vec3(part(), part(), part());
  return mesh;
}

bool Outcome::holds() const {
  return faults.empty() && (bound == Bound::AtMost ? figure <= limit : figure >= limit);  // false for NaN
}

std::vector<Outcome> run_all(const HardCase& hard_case) {
  std::vector<Outcome> outcomes;
  for (int run = 0; run <= kJitteredRuns; ++run) {
    Jitter jitter(run);
    outcomes.push_back(hard_case.run(jitter));
  }
  return outcomes;
}

Outcome worst(std::span<const Outcome> outcomes) {
  Outcome worst = outcomes.front();
  for (const Outcome& outcome : outcomes.subspan(1)) {
    const bool worse = outcome.bound == Bound::AtMost ? !(outcome.figure <= worst.figure)
                                                      : !(outcome.figure >= worst.figure);
    if (worse) worst.figure = outcome.figure;
    take_larger(worst.kuroda, outcome.kuroda);
    take_larger(worst.sibille, outcome.sibille);
    worst.checks += outcome.checks;
    worst.faults.insert(worst.faults.end(), outcome.faults.begin(), outcome.faults.end());
  }
  return worst;
}

}  // namespace palpate::hard_cases
