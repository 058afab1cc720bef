#pragma once

#include "analysis/description/statistic.hpp"
#include "analysis/resampling/bootstrap.hpp"

namespace palpate::analysis {

/// "resamples", of a bootstrap interval.
Input resamples_input();

/// From "level", "resamples" and "seed".
BootstrapOptions bootstrap_options(const Arguments& asked);

/// The name of each column of a matrix; "1", "2", ... without a header.
std::vector<std::string> matrix_names(const DataTable& table);

}  // namespace palpate::analysis
