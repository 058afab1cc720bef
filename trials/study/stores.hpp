#pragma once

#include <filesystem>
#include <utility>

#include "trials/study/answer_store.hpp"
#include "trials/study/connection.hpp"
#include "trials/study/event_store.hpp"
#include "trials/study/head_file.hpp"
#include "trials/study/ledger_store.hpp"
#include "trials/study/presentation_store.hpp"
#include "trials/study/session_lock.hpp"
#include "trials/study/session_store.hpp"
#include "trials/study/study_file.hpp"
#include "trials/study/study_store.hpp"
#include "trials/study/trial_store.hpp"

namespace palpate::trials {

/// An open database with one store a table. Kept behind a pointer: stores refer to the database beside them.
struct StudyFile::Stores {
  Stores(std::filesystem::path file, SQLite::Database opened)
      : path(std::move(file)),
        database(std::move(opened)),
        study(StudyStore(database).get()),
        design(parse_protocol(study.protocol_text, path)) {}

  std::filesystem::path path;
  SessionLock lock{};  // before the connection: it must outlive it
  SQLite::Database database;
  StudyRow study;
  Protocol design;
  SessionStore sessions{database};
  TrialStore trials{database, design};
  PresentationStore presentations{database, design};
  LedgerStore ledger{database};
  AnswerStore answers{database};
  EventStore events{database};

  /// Adds an event to the chain; inside a transaction of the caller's.
  void append(const EventRow& event) { events.add(ledger.append(study, canonical_text(event)), event); }

  /// After a commit that added to the chain, before anybody is told that it is saved: what was committed no
  /// longer hangs on the write-ahead log alone, and the head beside the file tells how far the chain went.
  void settle() {
    fold_in_log(database);
    write_head(path, {study.uuid, ledger.head(study)});
  }
};

}  // namespace palpate::trials
