#pragma once

#include <nlohmann/json_fwd.hpp>

#include "analysis/statistics/sign/sign_test.hpp"

namespace palpate::analysis {

/// As `palpate stats` prints it and the report holds it.
nlohmann::ordered_json to_json(const SignTest& test);

}  // namespace palpate::analysis
