#include <cassert>

#include "tasks/two_interval/two_interval.hpp"
#include "trials/observer/observer.hpp"
#include "trials/protocol/protocol.hpp"

namespace palpate::tasks::two_interval {

/// The interval that felt stiffer, or softer where that is asked for; a coin decides a lapse, and where one
/// interval gave nothing to compare.
int decide(const trials::Protocol& protocol, std::span<const std::optional<double>> percepts,
           const trials::Observer& observer, trials::Generator& generator) {
  assert(percepts.size() == 2);
  const std::optional<double>&first = percepts[0], &second = percepts[1];
  const bool lapse = generator.uniform() < observer.parameters->lapse_rate;
  const bool coin = generator.coin();
  if (lapse || !first || !second) return coin ? 2 : 1;
  const double sense = protocol.answer == trials::Answer::Softest ? -1.0 : 1.0;
  const double difference =
      sense * (*second - *first) + observer.interval_bias * trials::deviation_of_difference(observer);
  if (difference == 0.0) return coin ? 2 : 1;
  return difference > 0.0 ? 2 : 1;
}

}  // namespace palpate::tasks::two_interval
