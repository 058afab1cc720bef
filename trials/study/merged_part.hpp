#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "trials/study/event.hpp"
#include "trials/study/receipt.hpp"

namespace palpate::trials {

/// A study file that another one was joined from, as it was then.
struct MergedPart {
  std::string site{};  // put before its examinees' codes, "Osaka-P01"; empty: they stayed as they were
  std::string file{};  // its name, without folders
  std::string uuid{}, created_utc{}, software_version{};
  std::int64_t sessions = 0;
  Receipt receipt{};

  bool operator==(const MergedPart&) const = default;
};

/// The parts of a joined study file, in order; none where it was not joined. Throws std::invalid_argument
/// when what is written of them cannot be read.
std::vector<MergedPart> merged_parts(const std::vector<EventRow>& events);

/// The text of the event that tells what a file was joined from; merged_parts() reads it.
std::string merged_text(const std::vector<MergedPart>& parts);

}  // namespace palpate::trials
