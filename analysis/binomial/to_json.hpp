#pragma once

#include <nlohmann/json_fwd.hpp>

#include "analysis/binomial/binomial_power.hpp"
#include "analysis/binomial/binomial_test.hpp"
#include "analysis/binomial/critical_number.hpp"

namespace palpate::analysis {

// As `palpate stats` prints them and the report holds them.

nlohmann::ordered_json to_json(const BinomialTest& test);
nlohmann::ordered_json to_json(const CriticalNumber& critical);
nlohmann::ordered_json to_json(const SampleSize& size);

}  // namespace palpate::analysis
