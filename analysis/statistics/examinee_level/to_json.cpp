#include "analysis/statistics/examinee_level/to_json.hpp"

#include <nlohmann/json.hpp>

#include "analysis/numerics/to_json.hpp"
#include "analysis/resampling/to_json.hpp"

namespace palpate::analysis {

using nlohmann::ordered_json;

ordered_json to_json(const ExamineeLevelTest& test) {
  return {{"procedure", "examinee-level"},
          {"examinees", test.examinees},
          {"chance", test.chance},
          {"mean_proportion", test.mean_proportion},
          {"standard_deviation", test.examinees > 1 ? to_json(test.deviation) : ordered_json(nullptr)},
          {"standardised_mean", test.standardised ? to_json(*test.standardised) : ordered_json(nullptr)},
          {"p_values", to_json(test.p)},
          {"interval", to_json(test.interval)},
          {"test", to_json(test.test)},
          {"method", to_json(test.method)}};
}

}  // namespace palpate::analysis
