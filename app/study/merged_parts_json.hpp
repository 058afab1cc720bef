#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "trials/study/merged_part.hpp"

namespace palpate::app {

/// The files that a study file was joined from, as `verify` and `merge` print them.
inline nlohmann::ordered_json parts_json(const std::vector<trials::MergedPart>& parts) {
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (const trials::MergedPart& part : parts)
    all.push_back({{"file", part.file},
                   {"site", part.site},
                   {"study", part.uuid},
                   {"sessions", part.sessions},
                   {"receipt", trials::to_string(part.receipt)}});
  return all;
}

}  // namespace palpate::app
