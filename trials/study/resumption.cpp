#include "trials/study/resumption.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace palpate::trials {
namespace {

constexpr std::string_view kProgram = "palpate ", kOn = " on ";

}  // namespace

std::string resumed_text(std::string_view software_version, std::string_view machine) {
  return fmt::format("{}{}{}{}", kProgram, software_version, kOn, machine);
}

std::optional<std::string> version_resumed_by(const EventRow& event) {
  const auto end = event.text.find(kOn);
  if (event.kind != event_kind::kResumed || !event.text.starts_with(kProgram) || end == std::string::npos)
    return std::nullopt;
  return event.text.substr(kProgram.size(), end - kProgram.size());
}

std::vector<std::string> versions_that_resumed(const std::vector<EventRow>& events, std::int64_t session) {
  std::vector<std::string> versions;
  for (const EventRow& event : events) {
    if (event.session != session) continue;
    const auto version = version_resumed_by(event);
    if (version && std::ranges::find(versions, *version) == versions.end()) versions.push_back(*version);
  }
  return versions;
}

}  // namespace palpate::trials
