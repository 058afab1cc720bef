#include "analysis/detection/count_pair.hpp"

#include <fmt/core.h>

#include <stdexcept>

#include "analysis/words/words.hpp"

namespace palpate::analysis {

Input count_pair_input(const std::string& name, const std::string& part, const std::string& whole) {
  return {
      .name = name, .kind = Input::Kind::Counts, .meaning = fmt::format("Two counts: {}, {}", part, whole)};
}

std::pair<long, long> count_pair(const Arguments& asked, const std::string& name) {
  const std::vector<long> counts = asked.counts(name);
  if (counts.size() == 2) return {counts[0], counts[1]};
  throw std::invalid_argument(fmt::format("{} has {}; accepted: two, a part and its whole, such as 20,30",
                                          name,
                                          counted(static_cast<long>(counts.size()), "count", "counts")));
}

}  // namespace palpate::analysis
