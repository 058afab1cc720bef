#pragma once

#include <filesystem>
#include <optional>
#include <vector>

namespace palpate::app::message_times {

/// What the page at the other end of the socket can time of one interval [ms]; nothing where a slow machine let it
/// miss a message.
struct IntervalTimes {
  std::optional<double>
      from_start{};  // from "go on" until the interval is shown; not of a trial's later ones
  std::optional<double> from_pause{};   // from the pause until the interval is shown; of these
  std::optional<double> first_probe{};  // from there until the first message about the pointer
  std::optional<double> longest_gap{};  // between two of these
  std::optional<double> typical_gap{};  // their median
  std::optional<double> to_over{};      // from the first press until a message says that the interval is over
  std::optional<double> to_outcome{};   // from there until the page hears what comes next
};

/// Opens the page whose link is kept in `link` and sits until every question is answered, with the same movement
/// of the hand in every interval: one press to 1.3 times `asked` [m]. Throws what goes wrong.
std::vector<IntervalTimes> sit_through(const std::filesystem::path& link, double asked);

}  // namespace palpate::app::message_times
