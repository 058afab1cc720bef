#include "analysis/statistics/interval_bias/interval_bias.hpp"

#include <limits>

#include "analysis/binomial/binomial_test.hpp"
#include "analysis/numerics/proportion_interval.hpp"

namespace palpate::analysis {
namespace {

void fill_order(long correct, long trials, double level, double& rate, Interval& interval) {
  rate = std::numeric_limits<double>::quiet_NaN();
  interval = {.lower = 0.0, .upper = 1.0, .level = level, .method = "no trials of this order"};
  if (trials == 0) return;
  rate = static_cast<double>(correct) / static_cast<double>(trials);
  interval = clopper_pearson(correct, trials, level);
}

}  // namespace

IntervalBias interval_bias(const OrderCounts& counts, DPrimeCorrection correction, double level) {
  if (counts.trials_first != 0 || counts.correct_first != 0) {
    require_counts(counts.correct_first, counts.trials_first);
  }
  if (counts.trials_second != 0 || counts.correct_second != 0 || counts.trials_first == 0) {
    require_counts(counts.correct_second, counts.trials_second);
  }
  IntervalBias bias{.counts = counts};
  fill_order(counts.correct_first, counts.trials_first, level, bias.hit_rate_first, bias.interval_first);
  fill_order(counts.correct_second, counts.trials_second, level, bias.hit_rate_second, bias.interval_second);
  bias.answers = counts.trials_first + counts.trials_second;
  bias.answers_first = counts.correct_first + (counts.trials_second - counts.correct_second);
  bias.share_first = static_cast<double>(bias.answers_first) / static_cast<double>(bias.answers);
  bias.share_interval = clopper_pearson(bias.answers_first, bias.answers, level);
  bias.p = binomial_p(bias.answers_first, bias.answers, 0.5);
  if (counts.trials_first > 0 && counts.trials_second > 0) {
    bias.d_prime = dprime_2ifc_by_order(counts.correct_first, counts.trials_first, counts.correct_second,
                                        counts.trials_second, correction, level);
  }
  bias.method = {.name = "exact binomial test of the answers '1' against 1/2",
                 .source = "Clopper & Pearson 1934"};
  return bias;
}

}  // namespace palpate::analysis
