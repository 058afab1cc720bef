#include "trials/study/chain_parts.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "trials/study/ledger_store.hpp"

namespace palpate::trials {

std::string code_at_site(const std::string& site, const std::string& code) {
  return site.empty() ? code : fmt::format("{}-{}", site, code);
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
