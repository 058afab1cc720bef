#include "analysis/resampling/to_json.hpp"

#include <nlohmann/json.hpp>

#include "analysis/numerics/to_json.hpp"

namespace palpate::analysis {

using nlohmann::ordered_json;

ordered_json to_json(const SignFlipTest& test) {
  return {{"procedure", "permutation"},
          {"n", test.n},
          {"mean", test.mean},
          {"p_values", to_json(test.p)},
          {"exact", test.exact},
          {"resamples", test.resamples},
          {"seed", test.seed ? ordered_json(*test.seed) : ordered_json(nullptr)},
          {"interval", to_json(test.interval)},
          {"method", to_json(test.method)}};
}

}  // namespace palpate::analysis
