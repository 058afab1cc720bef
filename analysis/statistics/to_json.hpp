#pragma once

#include <nlohmann/json_fwd.hpp>

#include "analysis/statistics/binomial_power.hpp"
#include "analysis/statistics/binomial_test.hpp"
#include "analysis/statistics/critical_number.hpp"
#include "analysis/statistics/dprime.hpp"
#include "analysis/statistics/examinee_level.hpp"
#include "analysis/statistics/interval_bias.hpp"
#include "analysis/statistics/mcnemar.hpp"
#include "analysis/statistics/sign_flip.hpp"
#include "analysis/statistics/sign_test.hpp"
#include "analysis/statistics/signed_rank.hpp"

namespace palpate::analysis {

// Results as JSON, the same for `palpate stats` and in the report. Numbers are given with all their digits;
// what is infinite or undefined is null. Proportions are fractions, not percent.

nlohmann::ordered_json to_json(double value);  // null where it is not finite
nlohmann::ordered_json to_json(const Interval& interval);
nlohmann::ordered_json to_json(const PValues& p);
nlohmann::ordered_json to_json(const Method& method);
nlohmann::ordered_json to_json(const BinomialTest& test);
nlohmann::ordered_json to_json(const CriticalNumber& critical);
nlohmann::ordered_json to_json(const SampleSize& size);
nlohmann::ordered_json to_json(const DPrime& d_prime);
nlohmann::ordered_json to_json(const IntervalBias& bias);
nlohmann::ordered_json to_json(const SignFlipTest& test);
nlohmann::ordered_json to_json(const SignedRankTest& test);
nlohmann::ordered_json to_json(const SignTest& test);
nlohmann::ordered_json to_json(const McNemarTest& test);
nlohmann::ordered_json to_json(const ExamineeLevelTest& test);

}  // namespace palpate::analysis
