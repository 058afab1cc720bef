#include "analysis/statistics/wilcoxon/to_json.hpp"

#include <nlohmann/json.hpp>

#include "analysis/numerics/to_json.hpp"

namespace palpate::analysis {

using nlohmann::ordered_json;

ordered_json to_json(const SignedRankTest& test) {
  return {{"procedure", "wilcoxon"},
          {"n", test.n},
          {"zeros", test.zeros},
          {"ties", test.ties},
          {"zeros_rule", name_of(test.zeros_rule)},
          {"v", test.v},
          {"v_max", test.v_max},
          {"rank_biserial", test.rank_biserial},
          {"p_values", to_json(test.p)},
          {"exact", test.exact},
          {"pseudo_median", test.pseudo_median},
          {"interval", to_json(test.interval)},
          {"method", to_json(test.method)}};
}

}  // namespace palpate::analysis
