#pragma once

#include <nlohmann/json_fwd.hpp>

#include "analysis/resampling/sign_flip.hpp"

namespace palpate::analysis {

/// As `palpate stats` prints it and the report holds it.
nlohmann::ordered_json to_json(const SignFlipTest& test);

}  // namespace palpate::analysis
