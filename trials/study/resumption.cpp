#include "trials/study/resumption.hpp"

#include <fmt/format.h>

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

}  // namespace palpate::trials
