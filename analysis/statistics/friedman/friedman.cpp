#include "analysis/statistics/friedman/friedman.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <limits>
#include <stdexcept>

#include "analysis/numerics/rounding.hpp"
#include "analysis/resampling/shuffled_rows.hpp"
#include "base/text/counted.hpp"

namespace palpate::analysis {
namespace {

struct RankedRow {
  std::vector<long> doubled{};  // twice the mid-rank of each column
  double ties = 0.0;            // sum of t^3 - t over the groups of equal values
};

RankedRow rank(const std::vector<std::vector<double>>& columns, std::size_t row) {
  RankedRow ranked;
  std::vector<double> values;
  values.reserve(columns.size());
  for (const std::vector<double>& column : columns) values.push_back(column[row]);
  values = settled_values(values);
  for (const double mine : values) {
    const long below = std::ranges::count_if(values, [&](double other) { return other < mine; });
    const long alike = std::ranges::count(values, mine);
    ranked.doubled.push_back(2 * below + alike + 1);
    ranked.ties += static_cast<double>(alike * alike - 1);  // t of them add t (t^2 - 1)
  }
  return ranked;
}

// Kendall's W of those examinees; 0 where all of them tie everything.
double concordance(const std::vector<RankedRow>& rows, std::span<const std::size_t> chosen) {
  const std::size_t columns = rows.front().doubled.size();
  const double k = static_cast<double>(columns), n = static_cast<double>(chosen.size());
  double squares = 0.0, ties = 0.0;
  for (std::size_t j = 0; j < columns; ++j) {
    double sum = 0.0;
    for (const std::size_t row : chosen) sum += 0.5 * static_cast<double>(rows[row].doubled[j]);
    squares += (sum - n * (k + 1) / 2) * (sum - n * (k + 1) / 2);
  }
  for (const std::size_t row : chosen) ties += rows[row].ties;
  const double most = n * (n * k * (k * k - 1) - ties) / 12;
  return most > 0 ? squares / most : 0.0;
}

void validate(const std::vector<std::vector<double>>& columns) {
  if (columns.size() < 2) {
    throw std::invalid_argument(
        fmt::format("{}; at least 2 are compared", base::counted(std::ssize(columns), "column", "columns")));
  }
  for (const std::vector<double>& column : columns) {
    if (column.size() != columns.front().size()) {
      throw std::invalid_argument("the columns differ in length; every examinee judges everything");
    }
    for (const double value : column) require_finite(value, "value");
  }
  if (columns.front().size() < 2) {
    throw std::invalid_argument(fmt::format("{}; at least 2 examinees are needed",
                                            base::counted(std::ssize(columns.front()), "row", "rows")));
  }
}

}  // namespace

FriedmanTest friedman_test(const std::vector<std::vector<double>>& columns, const BootstrapOptions& options) {
  validate(columns);
  FriedmanTest test{.n = columns.front().size(), .degrees_of_freedom = static_cast<long>(columns.size()) - 1};
  std::vector<RankedRow> rows;
  std::vector<std::vector<long>> ranks;
  std::vector<std::size_t> everybody;
  test.mean_ranks.assign(columns.size(), 0.0);
  bool all_tied = true;
  for (std::size_t row = 0; row < test.n; ++row) {
    rows.push_back(rank(columns, row));
    ranks.push_back(rows.back().doubled);
    everybody.push_back(row);
    test.ties |= rows.back().ties > 0;
    for (std::size_t j = 0; j < columns.size(); ++j) {
      test.mean_ranks[j] += 0.5 * static_cast<double>(rows.back().doubled[j]) / static_cast<double>(test.n);
      all_tied &= rows.back().doubled[j] == rows.back().doubled.front();
    }
  }
  const double w = concordance(rows, everybody);
  test.chi_squared = w * static_cast<double>(test.n) * static_cast<double>(test.degrees_of_freedom);
  test.p_asymptotic = cdf(
      complement(boost::math::chi_squared(static_cast<double>(test.degrees_of_freedom)), test.chi_squared));
  test.p_exact = shuffled_rows_p(ranks);
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  test.kendall_w = all_tied ? kNone : w;
  test.w_interval = all_tied
                        ? Interval{.lower = kNone, .upper = kNone, .level = options.level, .method = "none"}
                        : bootstrap_interval(
                              test.n, [&](auto chosen) { return concordance(rows, chosen); }, options);
  test.method = {.name = "Friedman's rank test, ties corrected, with Kendall's W",
                 .source = "Friedman 1937; Conover 1999, section 5.8; Kendall & Babington Smith 1939"};
  return test;
}

}  // namespace palpate::analysis
