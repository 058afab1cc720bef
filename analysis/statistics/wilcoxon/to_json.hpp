#pragma once

#include <nlohmann/json_fwd.hpp>

#include "analysis/statistics/wilcoxon/signed_rank.hpp"

namespace palpate::analysis {

/// As `palpate stats` prints it and the report holds it.
nlohmann::ordered_json to_json(const SignedRankTest& test);

}  // namespace palpate::analysis
