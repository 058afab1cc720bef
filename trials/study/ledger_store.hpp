#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "trials/study/connection.hpp"
#include "trials/study/event.hpp"
#include "trials/study/receipt.hpp"
#include "trials/study/rows.hpp"

namespace palpate::trials {

struct LedgerEntry {
  std::int64_t entry = 0;
  std::string previous_hash, hash;
};

/// The hash that the first entry builds on: it ties the chain to this very study.
std::string genesis(const StudyRow& study);

/// Hash of an entry: SHA-256 of the previous one's hash and the entry's text.
std::string chain_hash(std::string_view previous_hash, std::string_view text);

// What is hashed: every value that a reader relies on, one a line, doubles with all their digits. An answer's
// text holds the sitting, the trial as drawn and what was felt, so that none of these can be altered later
// either.
std::string canonical_text(const Protocol& design, const SessionRow& session, const DrawnTrial& trial,
                           const std::vector<PresentationRow>& felt, const AnswerRow& answer);
std::string canonical_text(const EventRow& event);

// The texts of two events, so that orders are in the chain before they are answered, and exposure is though
// it led to no answer. One value a line: name=value.
/// A sitting's facts, the number of its trials, and the SHA-256 of all of them as first drawn.
std::string begun_text(const Protocol& design, const SessionRow& session,
                       const std::vector<DrawnTrial>& plan);
/// A trial as drawn again, and the SHA-256 of all that was felt of the draw that it replaces.
std::string drawn_again_text(const Protocol& design, const DrawnTrial& next,
                             const std::vector<PresentationRow>& felt_before);

/// The chain over answers and events.
class LedgerStore {
 public:
  explicit LedgerStore(SQLite::Database& database) : database_(database) {}

  Receipt head(const StudyRow& study) const;
  /// Appends an entry and returns its number. Call it inside the transaction that adds the row it stands for.
  std::int64_t append(const StudyRow& study, std::string_view text);
  /// Adds an entry as it is: one that another study's chain holds already, or that begins a chain.
  void add(const LedgerEntry& entry);
  std::vector<LedgerEntry> all() const;

 private:
  SQLite::Database& database_;
};

}  // namespace palpate::trials
