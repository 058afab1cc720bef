#pragma once

#include <string>
#include <utility>

#include "analysis/description/statistic.hpp"

namespace palpate::analysis {

/// An input that takes two counts, a part and its whole: `--signal 20,30`.
Input count_pair_input(const std::string& name, const std::string& part, const std::string& whole);

/// Its two counts. Throws std::invalid_argument where there are not two.
std::pair<long, long> count_pair(const Arguments& asked, const std::string& name);

}  // namespace palpate::analysis
