#include "analysis/statistics/to_json.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

namespace palpate::analysis {

using nlohmann::ordered_json;

namespace {

ordered_json optional_json(const std::optional<long>& value) {
  return value ? ordered_json(*value) : ordered_json(nullptr);
}

}  // namespace

ordered_json to_json(double value) {
  return std::isfinite(value) ? ordered_json(value) : ordered_json(nullptr);
}

ordered_json to_json(const Interval& interval) {
  return {{"lower", to_json(interval.lower)},
          {"upper", to_json(interval.upper)},
          {"level", interval.level},
          {"method", interval.method}};
}

ordered_json to_json(const PValues& p) {
  return {{"greater", p.greater}, {"less", p.less}, {"two_sided", p.two_sided}};
}

ordered_json to_json(const Method& method) {
  return {{"name", method.name}, {"source", method.source}};
}

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
