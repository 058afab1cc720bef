#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <string_view>
#include <vector>

namespace palpate::trials {

/// Which of the protocol's cells or conditions the file names. Throws std::invalid_argument, "the study file
/// is damaged: a trial names ...", where it has none of that name.
/// @param who  what names it: "a trial"
template <class Named>
std::size_t index_of(const std::vector<Named>& all, std::string_view name, std::string_view who) {
  const auto found = std::ranges::find(all, name, &Named::name);
  if (found == all.end())
    throw std::invalid_argument(fmt::format(
        "the study file is damaged: {} names \"{}\", which its protocol does not have", who, name));
  return found - all.begin();
}

}  // namespace palpate::trials
