#pragma once

#include <optional>
#include <string>
#include <vector>

#include "trials/study/event.hpp"
#include "trials/study/merged_part.hpp"
#include "trials/study/rows.hpp"

namespace palpate::trials {

/// Where the chains of a study file run. A joined file holds its parts' chains as they were, one after the
/// other, each from its own study's beginning; then its own, which begins with the event that names the parts
/// and their heads. A part's entries were hashed with its own session numbers and codes, which as_hashed()
/// gives back.
class ChainParts {
 public:
  ChainParts(const StudyRow& study, std::vector<MergedPart> parts);

  struct Chain {
    std::int64_t before = 0;   // entries of the file that come before it
    std::int64_t entries = 0;  // of a part; the file's own chain has no end
    std::int64_t sessions_before = 0;
    std::string genesis{};
    std::optional<MergedPart> part{};  // none: the file's own
  };
  const std::vector<Chain>& chains() const { return chains_; }  // the file's own is the last
  const Chain& chain_of(std::int64_t entry) const;

  const Chain& chain_of_session(std::int64_t session) const;
  /// Whether a sitting's code lost the site's name that was put before it when its part was joined.
  bool lacks_site(const SessionRow& session) const;

  SessionRow as_hashed(SessionRow session, std::int64_t entry) const;
  EventRow as_hashed(EventRow event) const;

 private:
  std::vector<Chain> chains_{};
};

/// A code with its site before it.
std::string code_at_site(const std::string& site, const std::string& code);

}  // namespace palpate::trials
