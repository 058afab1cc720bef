#include <fmt/ranges.h>

#include <algorithm>
#include <array>

#include "tasks/two_interval/two_interval.hpp"
#include "trials/protocol/reading.hpp"

namespace palpate::tasks::two_interval {

using trials::IntervalOrder;

constexpr std::array<base::Key, 2> kKeys{
    base::Key{.name = "pair",
              .takes = base::kTexts,
              .example = "[\"soft\", \"hard\"]",
              .meaning = "The two conditions that are compared: one in each interval."},
    base::Key{.name = "correct",
              .takes = base::kText,
              .example = "\"hard\"",
              .meaning = "The condition that the correct answer points at."},
};
constexpr std::array<base::Key, 1> kOrderKeys{
    base::Key{.name = "interval",
              .takes = base::takes_word(base::words_of<trials::kIntervalOrderWords>),
              .example = "\"coin\"",
              .meaning = "How it is drawn which interval holds which condition."},
};

void read(base::TomlReader& task, trials::Protocol& protocol) {
  const std::vector<std::string> pair = task.texts("pair");
  if (pair.size() != 2 || pair[0] == pair[1])
    task.refuse("pair", "accepted: two different conditions such as [\"soft\", \"hard\"]");
  for (const std::string& name : pair)
    protocol.presented.push_back(trials::condition_index(task, "pair", protocol, name));
  const std::string correct = task.text("correct");
  protocol.correct = trials::condition_index(task, "correct", protocol, correct);
  if (std::ranges::find(pair, correct) == pair.end())
    task.refuse("correct",
                fmt::format("\"{}\" is not in the pair; accepted: {}", correct, fmt::join(pair, ", ")));
}

void read_order(base::TomlReader& order, trials::Protocol& protocol) {
  protocol.interval_order = order.word("interval", trials::kIntervalOrderWords);
  if (protocol.interval_order == IntervalOrder::Balanced && protocol.trials_per_examinee_per_cell % 2 != 0)
    order.refuse("interval", fmt::format("balances the two orders, and {} trials of a cell cannot be halved; "
                                         "accepted: an even trials_per_examinee_per_cell, or \"coin\"",
                                         protocol.trials_per_examinee_per_cell));
}

void check_primary(const base::TomlReader& analysis, const trials::Protocol& protocol) {
  const bool coin = protocol.interval_order == IntervalOrder::Coin;
  if (coin == (protocol.analysis.primary == trials::PrimaryAnalysis::PairedComparison)) return;
  analysis.refuse(
      "primary",
      coin ? "found \"order-randomisation\", which is for balanced orders; accepted with order.interval "
             "= \"coin\": \"paired-comparison\", which is the same test there"
           : "found \"paired-comparison\", which holds for coin flips only; accepted with "
             "order.interval = \"balanced\": \"order-randomisation\"");
}

}  // namespace palpate::tasks::two_interval
