#pragma once

#include <string>
#include <vector>

#include "analysis/statistics/bradley_terry/bradley_terry.hpp"

namespace palpate::analysis {

/// Who beat whom how often. wins[i][j]: item i was preferred to item j.
struct ComparisonGraph {
  std::vector<std::string> names{};  // sorted
  std::vector<std::vector<double>> wins{};
};

/// Throws std::invalid_argument where no scale of finite values can be made, as paired_scaling() says.
ComparisonGraph comparison_graph(const std::vector<Comparison>& comparisons);

}  // namespace palpate::analysis
