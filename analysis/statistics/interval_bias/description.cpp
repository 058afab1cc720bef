#include "analysis/statistics/interval_bias/description.hpp"

#include <fmt/core.h>

#include "analysis/description/phrases.hpp"
#include "analysis/detection/count_pair.hpp"
#include "analysis/detection/detection_words.hpp"
#include "analysis/numerics/to_json.hpp"
#include "analysis/statistics/interval_bias/interval_bias.hpp"
#include "analysis/statistics/interval_bias/to_json.hpp"
#include "analysis/words/words.hpp"

namespace palpate::analysis {
namespace {

std::string order_line(const std::string& interval, long correct, long trials, double rate,
                       const Interval& range) {
  if (trials == 0) return fmt::format("Correct in the {} interval: no trials\n", interval);
  return fmt::format("Correct in the {} interval: {} of {} answered so, {} ({} interval {})\n", interval,
                     correct, trials, percent(rate), short_percent(range.level), percent_range(range));
}

std::string in_words(const IntervalBias& bias, Side side) {
  const OrderCounts& counts = bias.counts;
  std::string text =
      order_line("first", counts.correct_first, counts.trials_first, bias.hit_rate_first,
                 bias.interval_first) +
      order_line("second", counts.correct_second, counts.trials_second, bias.hit_rate_second,
                 bias.interval_second) +
      fmt::format("{} of {} answers name the first interval: {}, {} interval {}\n", bias.answers_first,
                  bias.answers, percent(bias.share_first), short_percent(bias.share_interval.level),
                  percent_range(bias.share_interval)) +
      "Against 1/2: " + p_line(bias.p, side);
  if (bias.d_prime) {
    const DPrimeByOrder& by_order = *bias.d_prime;
    const std::string corrected =
        by_order.corrected ? fmt::format(", corrected ({})", name_of(by_order.correction)) : "";
    text += fmt::format(
        "Without the assumption of no bias: d' = {}, {} interval {}; c = {} (below 0: the first is "
        "favoured){}\n",
        number(by_order.d_prime), short_percent(by_order.interval.level), range(by_order.interval),
        number(by_order.criterion), corrected);
  }
  return text + method_line(bias.method);
}

Outcome interval_bias_outcome(const Arguments& asked) {
  const auto [correct_first, trials_first] = count_pair(asked, "first");
  const auto [correct_second, trials_second] = count_pair(asked, "second");
  const IntervalBias bias = interval_bias({.correct_first = correct_first,
                                           .trials_first = trials_first,
                                           .correct_second = correct_second,
                                           .trials_second = trials_second},
                                          correction_from_name(asked.text("correction")), asked.level());
  Outcome outcome{.json = to_json(bias), .text = in_words(bias, asked.side())};
  put_side(outcome.json, asked.side());
  return outcome;
}

}  // namespace

Statistic interval_bias_statistic() {
  return {
      .name = "interval-bias",
      .question = "Is one of the two intervals favoured?",
      .title = "interval bias of a two-interval forced choice",
      .teaches =
          "Where fair coins draw the order, \"first\" is the right answer to half of all trials, so it is "
          "half of all answers unless an interval is favoured, however much is felt: an exact binomial test "
          "of the number of such answers. A bias hides sensitivity: d' from the hit rates of both orders is "
          "free of it. With balanced orders the test errs on the safe side.",
      .inputs = {count_pair_input("first", "correct answers", "trials where the first interval was correct"),
                 count_pair_input("second", "correct answers",
                                  "trials where the second interval was correct"),
                 side_input("two-sided"), correction_input("half-trial"), level_input()},
      .outputs = {{"correct_condition_first", "Counts, hit rate and interval where the first was correct"},
                  {"correct_condition_second", "The same where the second was correct"},
                  {"answers_first_interval", "Answers that name the first interval"},
                  {"answers", "All answers"},
                  {"share_first_interval", "answers_first_interval/answers"},
                  {"share_interval", "for it, Clopper-Pearson"},
                  {"side", "Alternative that was asked for"},
                  {"p", "p value of that side; greater: the first interval is favoured"},
                  {"p_values", "of all three sides"},
                  {"d_prime_by_order",
                   "d', its standard error and interval, and criterion from both hit rates; null without "
                   "both orders"}},
      .example = {{"first", {26, 30}}, {"second", {15, 30}}},
      .run = interval_bias_outcome};
}

}  // namespace palpate::analysis
