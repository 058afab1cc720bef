#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace palpate::trials {

/// Kinds of events that mean something to this program; others are kept as they are.
namespace event_kind {
constexpr std::string_view kVoided = "voided";           // the trial does not count; the text is the reason
constexpr std::string_view kBegun = "session begun";     // the text: the sitting's facts, hash of its plan
constexpr std::string_view kDrawnAgain = "drawn again";  // the text: the trial, hash of what was felt before
constexpr std::string_view kInterrupted = "interrupted";
constexpr std::string_view kResumed = "resumed";
constexpr std::string_view kEnded = "session ended";
constexpr std::string_view kEarlyKey = "early key";
constexpr std::string_view kStrategy = "strategy";
constexpr std::string_view kChecklist = "checklist";
constexpr std::string_view kMerged = "merged";  // the file was joined from others; the text tells of which
}  // namespace event_kind

/// Things that happened apart from answers. Append-only, chained with the answers.
struct EventRow {
  std::int64_t entry = 0;  // in the hash chain; set by the file
  std::optional<std::int64_t> session{};
  std::optional<int> trial{};
  std::string kind{};  // see event_kind
  std::string text{};
  std::string utc{};
};

}  // namespace palpate::trials
