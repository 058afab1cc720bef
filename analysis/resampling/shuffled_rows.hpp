#pragma once

#include <optional>
#include <vector>

namespace palpate::analysis {

/// If the columns mean nothing, each row's values may stand in any order. P that the sum of the squares of
/// the column sums is at least the one seen, over all orders of all rows: the exact test of Cochran's Q and
/// of Friedman's statistic, which grow with it. Values are whole numbers >= 0, rows all of one length.
/// Counted row by row over the sums that can be reached, columns in order of their sums, for no column
/// differs from another. Empty where that takes more than `most_steps` additions of a row (about 0.1
/// microseconds each), or where the sums of a state do not fit into 64 bits.
std::optional<double> shuffled_rows_p(std::vector<std::vector<long>> rows, long most_steps = 10'000'000);

}  // namespace palpate::analysis
