#include "analysis/statistics/interval_bias/to_json.hpp"

#include <nlohmann/json.hpp>

#include "analysis/numerics/to_json.hpp"

namespace palpate::analysis {

using nlohmann::ordered_json;

ordered_json to_json(const IntervalBias& bias) {
  const auto order = [](long correct, long trials, double rate, const Interval& interval) -> ordered_json {
    return {{"correct", correct},
            {"trials", trials},
            {"hit_rate", to_json(rate)},
            {"interval", to_json(interval)}};
  };
  const OrderCounts& counts = bias.counts;
  ordered_json d_prime = nullptr;
  if (bias.d_prime) {
    d_prime = {{"d_prime", to_json(bias.d_prime->d_prime)},
               {"standard_error", to_json(bias.d_prime->standard_error)},
               {"interval", to_json(bias.d_prime->interval)},
               {"criterion", to_json(bias.d_prime->criterion)},
               {"corrected", bias.d_prime->corrected},
               {"correction", name_of(bias.d_prime->correction)},
               {"method", to_json(bias.d_prime->method)}};
  }
  return {{"procedure", "interval-bias"},
          {"correct_condition_first",
           order(counts.correct_first, counts.trials_first, bias.hit_rate_first, bias.interval_first)},
          {"correct_condition_second",
           order(counts.correct_second, counts.trials_second, bias.hit_rate_second, bias.interval_second)},
          {"answers_first_interval", bias.answers_first},
          {"answers", bias.answers},
          {"share_first_interval", bias.share_first},
          {"share_interval", to_json(bias.share_interval)},
          {"p_values", to_json(bias.p)},
          {"d_prime_by_order", d_prime},
          {"method", to_json(bias.method)}};
}

}  // namespace palpate::analysis
