#include "analysis/statistics/sign/to_json.hpp"

#include <nlohmann/json.hpp>

#include "analysis/numerics/to_json.hpp"

namespace palpate::analysis {

using nlohmann::ordered_json;

ordered_json to_json(const SignTest& test) {
  return {{"procedure", "sign"},
          {"n", test.n},
          {"positive", test.positive},
          {"negative", test.negative},
          {"zeros", test.zeros},
          {"p_values", to_json(test.p)},
          {"share_positive", to_json(test.share_positive)},
          {"share_interval", to_json(test.share_interval)},
          {"median", to_json(test.median)},
          {"interval", to_json(test.interval)},
          {"method", to_json(test.method)}};
}

}  // namespace palpate::analysis
