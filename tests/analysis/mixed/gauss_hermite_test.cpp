#include "analysis/mixed/gauss_hermite.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

using namespace palpate::analysis;

TEST(GaussHermite, AgreesWithAbramowitzAndStegun) {
  // Table 25.10, n = 5 (in rising order)
  const double table[][2] = {{-2.020182870456086, 0.01995324205905},
                             {-0.958572464613819, 0.3936193231522},
                             {0, 0.9453087204829},
                             {0.958572464613819, 0.3936193231522},
                             {2.020182870456086, 0.01995324205905}};
  const auto nodes = gauss_hermite(5);
  for (std::size_t k = 0; k < 5; ++k) {
    EXPECT_NEAR(nodes[k].t, table[k][0], 1e-14);
    EXPECT_NEAR(nodes[k].weight, table[k][1], 1e-13);
  }
}

TEST(GaussHermite, IntegratesMomentsUpToTwiceItsNodes) {
  for (int n = 1; n <= 50; ++n) {
    const auto nodes = gauss_hermite(n);
    for (int power = 0; power < std::min(2 * n, 30); power += 2) {
      double sum = 0;
      for (const QuadratureNode& node : nodes) sum += node.weight * std::pow(node.t, power);
      EXPECT_NEAR(sum / std::tgamma((power + 1) / 2.0), 1, 1e-11) << n << " nodes, power " << power;
    }
  }
}
