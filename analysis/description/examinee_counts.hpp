#pragma once

#include <vector>

#include "analysis/description/statistic.hpp"
#include "analysis/numerics/examinee_count.hpp"

namespace palpate::analysis {

/// Data of one row for each examinee: columns correct and trials.
Data examinee_counts_data();

/// Throws std::invalid_argument that tells the row whose counts cannot be.
std::vector<ExamineeCount> read_examinee_counts(const DataTable& table);

}  // namespace palpate::analysis
