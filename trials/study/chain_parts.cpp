#include "trials/study/chain_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "trials/study/ledger_store.hpp"

namespace palpate::trials {

using nlohmann::json;

std::string code_at_site(const std::string& site, const std::string& code) {
  return site.empty() ? code : site + "-" + code;
}

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
    throw std::invalid_argument(fmt::format(
        "the study file is damaged: of which files it was joined cannot be read ({})", error.what()));
  }
  return parts;
}

ChainParts::ChainParts(const StudyRow& study, std::vector<MergedPart> parts) {
  Chain next;
  for (MergedPart& part : parts) {
    StudyRow as_it_was = study;  // protocol and files are the same
    as_it_was.uuid = part.uuid;
    as_it_was.created_utc = part.created_utc;
    as_it_was.software_version = part.software_version;
    next.genesis = genesis(as_it_was);
    next.entries = part.receipt.entries;
    next.part = std::move(part);
    chains_.push_back(next);
    next.before += next.entries;
    next.sessions_before += next.part->sessions;
  }
  chains_.push_back({.before = next.before, .genesis = genesis(study)});
}

const ChainParts::Chain& ChainParts::chain_of(std::int64_t entry) const {
  const auto found = std::ranges::find_if(
      chains_, [&](const Chain& chain) { return chain.part && entry <= chain.before + chain.entries; });
  return found == chains_.end() ? chains_.back() : *found;
}

const ChainParts::Chain& ChainParts::chain_of_session(std::int64_t session) const {
  const auto found = std::ranges::find_if(chains_, [&](const Chain& chain) {
    return chain.part && session <= chain.sessions_before + chain.part->sessions;
  });
  return found == chains_.end() ? chains_.back() : *found;
}

bool ChainParts::lacks_site(const SessionRow& session) const {
  const Chain& chain = chain_of_session(session.id);
  return chain.part && !session.facts.examinee.starts_with(code_at_site(chain.part->site, ""));
}

SessionRow ChainParts::as_hashed(SessionRow session, std::int64_t entry) const {
  const Chain& chain = chain_of(entry);
  if (!chain.part || chain.part->site.empty()) return session;
  const std::string before = code_at_site(chain.part->site, "");
  if (session.facts.examinee.starts_with(before)) session.facts.examinee.erase(0, before.size());
  return session;
}

EventRow ChainParts::as_hashed(EventRow event) const {
  if (event.session) *event.session -= chain_of(event.entry).sessions_before;
  return event;
}

}  // namespace palpate::trials
