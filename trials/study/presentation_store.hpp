#pragma once

#include <vector>

#include "trials/study/connection.hpp"
#include "trials/study/rows.hpp"

namespace palpate::trials {

/// What was shown: a row when an interval begins, another when it ends, and its trace. Conditions are kept by
/// name; `design` says which is which.
class PresentationStore {
 public:
  PresentationStore(SQLite::Database& database, const Protocol& design)
      : database_(database), design_(design) {}
  /// Begins a presentation (session, trial, draw, interval, attempt, condition, begun_utc) and returns
  /// its id.
  std::int64_t begin(const PresentationRow& presentation);
  /// Ends it: all that is not set by begin(), the trace's checksum included.
  void end(const PresentationRow& presentation, const std::string& encoded_trace);
  std::vector<PresentationRow> of_session(std::int64_t session) const;
  /// The trace as encoded, with its number of samples; empty where none was stored.
  std::optional<std::pair<std::string, std::size_t>> trace(std::int64_t presentation) const;

 private:
  SQLite::Database& database_;
  const Protocol& design_;
};

}  // namespace palpate::trials
