#pragma once

#include <vector>

#include "trials/study/connection.hpp"
#include "trials/study/rows.hpp"

namespace palpate::trials {

/// Sittings as they were begun; whether they ended, or were resumed, is told by events.
class SessionStore {
 public:
  explicit SessionStore(SQLite::Database& database) : database_(database) {}
  std::int64_t add(const SessionRow& session);
  std::vector<SessionRow> all() const;

 private:
  SQLite::Database& database_;
};

}  // namespace palpate::trials
