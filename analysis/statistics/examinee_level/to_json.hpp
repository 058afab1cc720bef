#pragma once

#include <nlohmann/json_fwd.hpp>

#include "analysis/statistics/examinee_level/examinee_level.hpp"

namespace palpate::analysis {

/// As `palpate stats` prints it and the report holds it.
nlohmann::ordered_json to_json(const ExamineeLevelTest& test);

}  // namespace palpate::analysis
