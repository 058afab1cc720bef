#pragma once

#include <optional>
#include <string>
#include <vector>

namespace palpate::app::message_times {

/// How two samples of times differ.
struct TimeDifference {
  double share_longer =
      0.5;              // of pairs in which the second one's time is longer, ties half: the area under the
                        // ROC curve of whoever tells the two apart by this time
  double median = 0.0;  // of the second, from that of the first [ms]
  double chance = 0.0;  // standard deviation of share_longer where there is no difference [-]
};

TimeDifference difference(std::vector<double> first, std::vector<double> second);

/// Whether a page could learn from such times which of the two was shown.
bool leaks(const TimeDifference& difference);

}  // namespace palpate::app::message_times
