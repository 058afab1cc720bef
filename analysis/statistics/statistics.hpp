#pragma once

#include <string_view>
#include <vector>

#include "analysis/description/statistic.hpp"

namespace palpate::analysis {

/// All statistics, in the order of their names. The names are the contract of the command line.
const std::vector<Statistic>& statistics();

/// Throws std::invalid_argument that lists the names.
const Statistic& statistic_named(std::string_view name);

}  // namespace palpate::analysis
