#pragma once

#include <vector>

#include "trials/study/connection.hpp"
#include "trials/study/event.hpp"

namespace palpate::trials {

class EventStore {
 public:
  explicit EventStore(SQLite::Database& database) : database_(database) {}
  void add(std::int64_t entry, const EventRow& event);
  std::vector<EventRow> all() const;

 private:
  SQLite::Database& database_;
};

}  // namespace palpate::trials
