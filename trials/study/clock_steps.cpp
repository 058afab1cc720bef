#include "trials/study/clock_steps.hpp"

#include <fmt/format.h>

#include <ctime>
#include <optional>

namespace palpate::trials {
namespace {

// "2026-11-28T18:52:28.000Z" as seconds; the fraction is cut off.
std::optional<std::time_t> seconds_of(const std::string& utc) {
  std::tm time{};
  const char* end = ::strptime(utc.c_str(), "%Y-%m-%dT%H:%M:%S", &time);
  if (end == nullptr || (*end != '.' && *end != 'Z')) return std::nullopt;
  return ::timegm(&time);
}

}  // namespace

std::vector<ClockStep> clock_steps_back(const std::map<std::int64_t, std::string>& utc_of,
                                        const ChainParts& chains) {
  std::vector<ClockStep> steps;
  const std::string* before = nullptr;
  const ChainParts::Chain* before_in = nullptr;
  for (const auto& [entry, utc] : utc_of) {
    if (!seconds_of(utc)) continue;
    const ChainParts::Chain* in = &chains.chain_of(entry);
    if (in == before_in && *seconds_of(utc) < *seconds_of(*before))
      steps.push_back({.entry = entry, .before_utc = *before, .after_utc = utc});
    before = &utc;
    before_in = in;
  }
  return steps;
}

std::string in_words(const ClockStep& step) {
  return fmt::format("the clock was set back before entry {} of the chain, from {} to {}", step.entry,
                     step.before_utc, step.after_utc);
}

}  // namespace palpate::trials
