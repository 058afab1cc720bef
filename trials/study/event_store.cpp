#include "trials/study/event_store.hpp"

namespace palpate::trials {

void EventStore::add(std::int64_t entry, const EventRow& event) {
  Query(database_, "INSERT INTO event (entry, session, trial, kind, text, utc) VALUES (?, ?, ?, ?, ?, ?)",
        entry, event.session, event.trial, event.kind, event.text, event.utc)
      .run();
}

std::vector<EventRow> EventStore::all() const {
  std::vector<EventRow> events;
  Query rows(database_, "SELECT entry, session, trial, kind, text, utc FROM event ORDER BY entry");
  while (rows.next()) {
    EventRow event{.entry = rows.integer(0)};
    event.session = rows.optional_integer(1);
    if (!rows.is_null(2)) event.trial = rows.number(2);
    event.kind = rows.text(3);
    event.text = rows.text(4);
    event.utc = rows.text(5);
    events.push_back(std::move(event));
  }
  return events;
}

}  // namespace palpate::trials
