#include "trials/study/merged_part.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "base/text/json_words.hpp"

namespace palpate::trials {

using nlohmann::json;

std::string merged_text(const std::vector<MergedPart>& parts) {
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (const MergedPart& part : parts)
    all.push_back({{"site", part.site},
                   {"file", part.file},
                   {"study", part.uuid},
                   {"created_utc", part.created_utc},
                   {"software_version", part.software_version},
                   {"sessions", part.sessions},
                   {"receipt", to_string(part.receipt)}});
  return all.dump(-1, ' ', false, json::error_handler_t::replace);
}

std::vector<MergedPart> merged_parts(const std::vector<EventRow>& events) {
  const auto merged = std::ranges::find_if(
      events, [](const EventRow& event) { return event.kind == event_kind::kMerged && !event.session; });
  std::vector<MergedPart> parts;
  if (merged == events.end()) return parts;
  try {
    for (const json& part : json::parse(merged->text))
      parts.push_back({.site = part.at("site"),
                       .file = part.at("file"),
                       .uuid = part.at("study"),
                       .created_utc = part.at("created_utc"),
                       .software_version = part.at("software_version"),
                       .sessions = part.at("sessions"),
                       .receipt = parse_receipt(part.at("receipt").get<std::string>())});
  } catch (const json::exception& error) {
    throw std::invalid_argument(
        fmt::format("the study file is damaged: of which files it was joined cannot be read ({})",
                    base::json_words(error.what())));
  }
  return parts;
}

}  // namespace palpate::trials
