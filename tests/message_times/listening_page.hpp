#pragma once

#include <filesystem>
#include <optional>
#include <vector>

namespace palpate::app::message_times {

/// What the page at the other end of the socket can time of one interval [ms].
struct IntervalTimes {
  std::optional<double> from_start{};  // from "go on" until the interval is shown; of a trial's first one
  std::optional<double> from_pause{};  // from the pause until the interval is shown; of later ones
  double first_probe = 0.0;            // from there until the first message about the pointer
  double longest_gap = 0.0;            // between two of these
  double typical_gap = 0.0;            // their median
  double to_over = 0.0;                // from the first press until a message says that the interval is over
  double to_outcome = 0.0;             // from there until the page hears what comes next
};

/// Opens the page whose link is kept in `link` and sits until every question is answered, with the same movement
/// of the hand in every interval: one press to 1.3 times `asked` [m]. Throws what goes wrong.
std::vector<IntervalTimes> sit_through(const std::filesystem::path& link, double asked);

}  // namespace palpate::app::message_times
