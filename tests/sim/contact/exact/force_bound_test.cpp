#include "sim/contact/exact/force_bound.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <random>

#include "sim/contact/exact/exact.hpp"
#include "sim/cycle/simulation.hpp"
#include "tests/sim/contact/exact/lemke.hpp"
#include "tests/sim/support/two_boxes.hpp"

namespace palpate::sim {
namespace {

#ifdef __SANITIZE_ADDRESS__
constexpr int kSlower = 20;
#else
constexpr int kSlower = 1;
#endif

double median(std::vector<double> sample) {
  std::ranges::nth_element(sample, sample.begin() + std::ssize(sample) / 2);
  return sample[sample.size() / 2];
}

/// The pad of a finger anywhere in reach, as a walk with jumps: most steps are small.
class Strokes {
 public:
  explicit Strokes(const Probe& probe, std::uint64_t seed) : probe_(&probe), random_(seed) {}
  ProbeDisplacement next() {
    std::normal_distribution<double> step(0.0, 0.05e-3);
    std::uniform_real_distribution<double> anywhere(0.0, 1.0);
    const bool jumps = anywhere(random_) < 0.02;
    for (Eigen::Index k = 0; k < 3; ++k) {
      const double reach = probe_->direction[k] != 0.0 ? probe_->depth : 0.3 * probe_->depth;
      at_[k] =
          jumps ? reach * (2 * anywhere(random_) - 1) : std::clamp(at_[k] + step(random_), -reach, reach);
    }
    if (at_.dot(probe_->direction) < 0) at_ = -at_;
    return {.from_rest = at_};
  }

 private:
  const Probe* probe_;
  std::mt19937_64 random_;
  Vec3 at_ = Vec3::Zero();
};

Model pad_on_boxes(const char* tolerance) {
  return test::compile_scene(
      test::write_two_boxes({.divisions = 8,
                             .upper_divisions = 7,
                             .shift = 0.4e-3,
                             .probe = "kind = \"pad\"\nradius = \"6 mm\""}),
      std::vector<Override>{{"contact.model", "exact"}, {"contact.tolerance", tolerance}});
}

/// The force of the first probe by Lemke's method, from the scene's own system.
Vec3 force_by_lemke(const Model& model, const ExactScratch& scratch) {
  test::ContactProblem problem{
      .system = scratch.system, .holds = scratch.holds, .values = scratch.values, .gaps = scratch.gaps};
  const Eigen::VectorXd x = test::lemke(problem);
  return -model.probes[0].axes * x.head(model.probes[0].axes.cols());
}

// Whatever a cycle stopped with, the bound it tells holds. The reference is solved by Lemke's method, which knows the
// force to some 1e-9 of it.
TEST(ForceBound, HoldsAgainstLemkeAndIsNearTheError) {
  int compared = 0;
  for (const char* tolerance : {"0.2 %", "1 %", "5 %"}) {
    const Model model = pad_on_boxes(tolerance);
    Simulation simulation(model);
    Strokes strokes(model.probes[0], 11);
    std::vector<double> ratios;
    for (int cycle = 0; cycle < 6000 / kSlower; ++cycle) {
      const ProbeDisplacement at = strokes.next();
      const CycleResult result = simulation.step({&at, 1}, kCyclePeriod);
      if (result.solve.stop != Stop::WithinTolerance && cycle % 40 != 0) continue;
      const Vec3 force = result.probe_forces[0];
      const Vec3 exact = force_by_lemke(model, static_cast<const ExactScratch&>(*simulation.law_scratch()));
      const double error = (force - exact).norm();
      ++compared;
      ASSERT_LE(error, result.solve.force_error_bound + 1e-9 * exact.norm()) << cycle;
      if (result.solve.stop == Stop::WithinTolerance) {
        ASSERT_LE(result.solve.force_error_bound, std::stod(tolerance) / 100 * force.norm());
        ratios.push_back(result.solve.force_error_bound / error);
      }
    }
    ASSERT_GE(ratios.size(), 100U / kSlower);
    std::printf("tolerance %s: %zu cycles stopped early, bound over error: median %.2f\n", tolerance,
                ratios.size(), median(ratios));
    EXPECT_LE(median(ratios), 3.0);
  }
  EXPECT_GE(compared, kSlower == 1 ? 10'000 : 300);
}

// A compliance of 7 digits is one more error that the bound knows of.
TEST(ForceBound, HoldsInSinglePrecision) {
  Model single = pad_on_boxes("1 %");
  single.contact_tolerance = 0.0;
  single.contact_precision = Precision::Single;
  Model full = single;
  full.contact_precision = Precision::Double;
  Simulation rounded(single), exact(full);
  Strokes strokes(full.probes[0], 13);
  std::vector<double> ratios, errors;
  for (int cycle = 0; cycle < 20'000 / kSlower; ++cycle) {
    const ProbeDisplacement at = strokes.next();
    const CycleResult felt = rounded.step({&at, 1}, kCyclePeriod), right = exact.step({&at, 1}, kCyclePeriod);
    const double error = (felt.probe_forces[0] - right.probe_forces[0]).norm();
    ASSERT_LE(error, felt.solve.force_error_bound + right.solve.force_error_bound) << cycle;
    if (error == 0.0) continue;
    ratios.push_back(felt.solve.force_error_bound / error);
    errors.push_back(error / right.probe_forces[0].norm());
  }
  ASSERT_GE(ratios.size(), 1000U / kSlower);
  std::printf("single precision: error of the force up to %.2g of it, bound over error: median %.3g\n",
              std::ranges::max(errors), median(ratios));
  EXPECT_LT(std::ranges::max(errors), 1e-5);
  EXPECT_GT(median(errors), 1e-12);  // it does round
}

// A million cycles of two engines side by side: one may stop early, the other does not.
TEST(ForceBound, HoldsOverAMillionCycles) {
  const Model model = pad_on_boxes("10 %");
  Model solved = model;
  solved.contact_tolerance = 0.0;
  Simulation early(model), exact(solved);
  Strokes strokes(model.probes[0], 12);
  int stopped = 0;
  for (int cycle = 0; cycle < 1'000'000 / kSlower; ++cycle) {
    const ProbeDisplacement at = strokes.next();
    const CycleResult felt = early.step({&at, 1}, kCyclePeriod);
    const CycleResult right = exact.step({&at, 1}, kCyclePeriod);
    const double error = (felt.probe_forces[0] - right.probe_forces[0]).norm();
    ASSERT_LE(error, felt.solve.force_error_bound + right.solve.force_error_bound) << cycle;
    ASSERT_LE(right.solve.force_error_bound, 1e-8 * right.probe_forces[0].norm()) << cycle;
    stopped += felt.solve.stop == Stop::WithinTolerance ? 1 : 0;
  }
  EXPECT_GT(stopped, 10'000 / kSlower);
}

}  // namespace
}  // namespace palpate::sim
