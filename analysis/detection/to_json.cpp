#include "analysis/detection/to_json.hpp"

#include <nlohmann/json.hpp>

#include "analysis/numerics/to_json.hpp"

namespace palpate::analysis {

using nlohmann::ordered_json;

ordered_json to_json(const DPrime& d_prime) {
  const std::optional<Strategy>& strategy = d_prime.task.strategy;
  return {{"procedure", "dprime"},
          {"task", name_of(d_prime.task)},
          {"alternatives", d_prime.task.alternatives},
          {"strategy", strategy ? ordered_json(name_of(*strategy)) : ordered_json(nullptr)},
          {"chance", chance_of(d_prime.task)},
          {"correct", d_prime.correct},
          {"trials", d_prime.trials},
          {"proportion", d_prime.proportion},
          {"correction", name_of(d_prime.correction)},
          {"corrected", d_prime.corrected},
          {"d_prime", to_json(d_prime.d_prime)},
          {"standard_error", to_json(d_prime.standard_error)},
          {"interval", to_json(d_prime.interval)},
          {"method", to_json(d_prime.method)}};
}

}  // namespace palpate::analysis
