#include "analysis/statistics/mcnemar/to_json.hpp"

#include <nlohmann/json.hpp>

#include "analysis/numerics/to_json.hpp"

namespace palpate::analysis {

using nlohmann::ordered_json;

ordered_json to_json(const McNemarTest& test) {
  const PairedTable& table = test.table;
  return {{"procedure", "mcnemar"},
          {"table", {table.both, table.first_only, table.second_only, table.neither}},
          {"pairs", test.pairs},
          {"discordant", test.discordant},
          {"difference", test.difference},
          {"difference_interval", to_json(test.difference_interval)},
          {"odds_ratio", to_json(test.odds_ratio)},
          {"odds_ratio_interval", to_json(test.odds_ratio_interval)},
          {"exact_p_values", to_json(test.exact)},
          {"mid_p_values", to_json(test.mid_p)},
          {"chi_squared", test.chi_squared},
          {"p_asymptotic", test.p_asymptotic},
          {"chi_squared_corrected", test.chi_squared_corrected},
          {"p_asymptotic_corrected", test.p_asymptotic_corrected},
          {"degrees_of_freedom", 1},
          {"method", to_json(test.method)}};
}

}  // namespace palpate::analysis
