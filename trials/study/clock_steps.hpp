#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "trials/study/chain_parts.hpp"

namespace palpate::trials {

/// That the clock was set back while a study ran: an entry of the chain bears an earlier time than the one
/// that it follows. The chain tells the order all the same.
struct ClockStep {
  std::int64_t entry = 0;                 // the first written after it
  std::string before_utc{}, after_utc{};  // what the entries say
};

/// The steps back of a second and more, within each of the file's chains: sites have clocks of their own, and
/// a time server corrects by less. `utc_of` holds the time of each entry; one that is no ISO 8601 time is
/// passed over.
std::vector<ClockStep> clock_steps_back(const std::map<std::int64_t, std::string>& utc_of,
                                        const ChainParts& chains);

/// "the clock was set back before entry 12, from ... to ...".
std::string in_words(const ClockStep& step);

}  // namespace palpate::trials
