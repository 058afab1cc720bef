#include "analysis/statistics/cochran/cochran.hpp"

#include <fmt/core.h>

#include <boost/math/distributions/chi_squared.hpp>
#include <numeric>
#include <stdexcept>

#include "analysis/numerics/proportion_interval.hpp"
#include "analysis/resampling/shuffled_rows.hpp"
#include "base/text/counted.hpp"

namespace palpate::analysis {
namespace {

using Rows = std::vector<std::vector<long>>;

Rows rows_of(const std::vector<std::vector<double>>& columns) {
  if (columns.size() < 2) {
    throw std::invalid_argument(
        fmt::format("{}; at least 2 are compared", base::counted(std::ssize(columns), "column", "columns")));
  }
  Rows rows(columns.front().size(), std::vector<long>(columns.size()));
  if (rows.empty()) throw std::invalid_argument("no rows; Cochran's test needs at least 1");
  for (std::size_t j = 0; j < columns.size(); ++j) {
    if (columns[j].size() != rows.size()) {
      throw std::invalid_argument("the columns differ in length; every row has an answer in each");
    }
    for (std::size_t i = 0; i < rows.size(); ++i) {
      if (columns[j][i] != 0 && columns[j][i] != 1) {
        throw std::invalid_argument(fmt::format(
            "column {}, row {} is {}; accepted: 0 (wrong) and 1 (correct)", j + 1, i + 1, columns[j][i]));
      }
      rows[i][j] = columns[j][i] == 1;
    }
  }
  return rows;
}

// Q = k(k - 1) sum((C_j - mean)^2)/(k sum(R_i) - sum(R_i^2)); 0 without informative rows.
double q_of(const Rows& rows, std::span<const std::size_t> chosen) {
  const double k = static_cast<double>(rows.front().size());
  std::vector<double> columns(rows.front().size(), 0.0);
  double total = 0.0, spread = 0.0;
  for (const std::size_t i : chosen) {
    double correct = 0.0;
    for (std::size_t j = 0; j < columns.size(); ++j) {
      columns[j] += static_cast<double>(rows[i][j]);
      correct += static_cast<double>(rows[i][j]);
    }
    total += correct;
    spread += correct * (k - correct);
  }
  if (spread == 0) return 0.0;
  double squares = 0.0;
  for (const double column : columns) squares += (column - total / k) * (column - total / k);
  return k * (k - 1) * squares / spread;
}

}  // namespace

CochranTest cochran_test(const std::vector<std::vector<double>>& columns, const BootstrapOptions& options) {
  const Rows rows = rows_of(columns);
  CochranTest test{.n = rows.size(), .degrees_of_freedom = static_cast<long>(columns.size()) - 1};
  for (const std::vector<double>& column : columns) {
    const double correct = std::reduce(column.begin(), column.end());
    test.proportions.push_back(correct / static_cast<double>(test.n));
    test.intervals.push_back(
        clopper_pearson(static_cast<long>(correct), static_cast<long>(test.n), options.level));
  }
  std::vector<std::size_t> everybody(test.n);
  std::iota(everybody.begin(), everybody.end(), std::size_t{0});
  for (const std::vector<long>& row : rows) {
    const long correct = std::reduce(row.begin(), row.end());
    test.informative += correct > 0 && correct < std::ssize(row);
  }
  test.q = q_of(rows, everybody);
  test.p_asymptotic =
      cdf(complement(boost::math::chi_squared(static_cast<double>(test.degrees_of_freedom)), test.q));
  test.p_exact = shuffled_rows_p(rows);
  const auto effect = [&](std::span<const std::size_t> chosen) {
    return q_of(rows, chosen) /
           (static_cast<double>(chosen.size()) * static_cast<double>(test.degrees_of_freedom));
  };
  test.eta_squared = effect(everybody);
  test.eta_squared_interval = bootstrap_interval(test.n, effect, options);
  test.method = {.name = "Cochran's Q, exact (orders within rows) and asymptotic",
                 .source = "Cochran 1950; effect size Serlin, Carr & Marascuilo 1982"};
  return test;
}

}  // namespace palpate::analysis
