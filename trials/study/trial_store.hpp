#pragma once

#include <vector>

#include "trials/study/connection.hpp"
#include "trials/study/rows.hpp"

namespace palpate::trials {

/// Trials as drawn. Cells and conditions are kept by name; `design` says which is which.
class TrialStore {
 public:
  TrialStore(SQLite::Database& database, const Protocol& design) : database_(database), design_(design) {}
  void add(const DrawnTrial& trial);
  std::vector<DrawnTrial> of_session(std::int64_t session) const;

 private:
  SQLite::Database& database_;
  const Protocol& design_;
};

}  // namespace palpate::trials
