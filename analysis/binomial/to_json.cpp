#include "analysis/binomial/to_json.hpp"

#include <nlohmann/json.hpp>

#include "analysis/numerics/to_json.hpp"

namespace palpate::analysis {

using nlohmann::ordered_json;

ordered_json to_json(const BinomialTest& test) {
  return {{"procedure", "binomial"},
          {"correct", test.correct},
          {"trials", test.trials},
          {"chance", test.chance},
          {"side", name_of(test.side)},
          {"proportion", test.proportion},
          {"p", test.p.of(test.side)},
          {"p_values", to_json(test.p)},
          {"mid_p", test.mid_p.of(test.side)},
          {"mid_p_values", to_json(test.mid_p)},
          {"interval", to_json(test.interval)},
          {"bound", to_json(test.bound)},
          {"wilson", to_json(test.wilson)},
          {"jeffreys", to_json(test.jeffreys)},
          {"method", to_json(test.method)}};
}

ordered_json to_json(const CriticalNumber& critical) {
  return {{"procedure", "critical"},
          {"trials", critical.trials},
          {"chance", critical.chance},
          {"alpha", critical.alpha},
          {"side", name_of(critical.side)},
          {"at_least", optional_json(critical.at_least)},
          {"at_most", optional_json(critical.at_most)},
          {"size", critical.size},
          {"method", to_json(critical.method)}};
}

ordered_json to_json(const SampleSize& size) {
  return {{"procedure", "sample-size"},
          {"chance", size.chance},
          {"probability", size.probability},
          {"alpha", size.alpha},
          {"side", name_of(size.side)},
          {"target_power", size.target},
          {"step", size.step},
          {"first", optional_json(size.first)},
          {"power_at_first", size.first ? to_json(size.power_at_first) : ordered_json(nullptr)},
          {"lasting", optional_json(size.lasting)},
          {"power_at_lasting", size.lasting ? to_json(size.power_at_lasting) : ordered_json(nullptr)},
          {"searched", size.searched},
          {"method", to_json(size.method)}};
}

}  // namespace palpate::analysis
