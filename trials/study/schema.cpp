#include "trials/study/schema.hpp"

#include <SQLiteCpp/SQLiteCpp.h>
#include <fmt/format.h>

#include <array>
#include <map>

#include "trials/study/connection.hpp"

namespace palpate::trials {
namespace {

// Names in the tables (condition, cell) are those of the protocol's text, which the study row keeps.
constexpr const char* kTables = R"sql(
CREATE TABLE study (
  id               INTEGER PRIMARY KEY CHECK (id = 1),
  uuid             TEXT NOT NULL,
  created_utc      TEXT NOT NULL,
  protocol_name    TEXT NOT NULL,
  protocol_text    TEXT NOT NULL,
  protocol_sha256  TEXT NOT NULL,
  scene_text       TEXT NOT NULL,
  software_version TEXT NOT NULL
) STRICT;
CREATE TABLE study_file (
  position INTEGER PRIMARY KEY,
  name     TEXT NOT NULL UNIQUE,
  file     TEXT NOT NULL,
  sha256   TEXT NOT NULL
) STRICT;
CREATE TABLE session (
  id               INTEGER PRIMARY KEY,
  examinee         TEXT NOT NULL,
  number           INTEGER NOT NULL,
  run_mode         TEXT NOT NULL CHECK (run_mode IN ('study', 'pilot', 'practice', 'simulated')),
  started_utc      TEXT NOT NULL,
  software_version TEXT NOT NULL,
  machine          TEXT NOT NULL,
  device           TEXT NOT NULL,
  pseudo_haptic    INTEGER NOT NULL CHECK (pseudo_haptic IN (0, 1)),
  channel          TEXT NOT NULL,
  force_scale      REAL NOT NULL,
  seed             TEXT,
  observer         TEXT,
  UNIQUE (examinee, number)
) STRICT;
CREATE TABLE trial (
  session          INTEGER NOT NULL REFERENCES session (id),
  number           INTEGER NOT NULL,
  draw             INTEGER NOT NULL,
  block            INTEGER NOT NULL,
  cell             TEXT NOT NULL,
  interval_order   TEXT NOT NULL,
  correct_interval INTEGER NOT NULL,
  PRIMARY KEY (session, number, draw)
) STRICT, WITHOUT ROWID;
CREATE TABLE presentation (
  id        INTEGER PRIMARY KEY,
  session   INTEGER NOT NULL,
  trial     INTEGER NOT NULL,
  draw      INTEGER NOT NULL,
  interval  INTEGER NOT NULL,
  attempt   INTEGER NOT NULL,
  condition TEXT NOT NULL,
  begun_utc TEXT NOT NULL,
  UNIQUE (session, trial, draw, interval, attempt),
  FOREIGN KEY (session, trial, draw) REFERENCES trial (session, number, draw)
) STRICT;
CREATE TABLE presentation_end (
  presentation       INTEGER PRIMARY KEY REFERENCES presentation (id),
  onset_utc          TEXT NOT NULL,
  verdict            TEXT NOT NULL,
  n_presses          INTEGER NOT NULL,
  exploration_time_s REAL NOT NULL,
  peak_force_n       REAL NOT NULL,
  max_depth_m        REAL NOT NULL,
  clamped_fraction   REAL NOT NULL,
  loop_rate_hz       REAL,
  loop_p999_ms       REAL,
  missed_cycles      INTEGER,
  CHECK ((loop_rate_hz IS NULL) = (loop_p999_ms IS NULL) AND
         (loop_rate_hz IS NULL) = (missed_cycles IS NULL))
) STRICT;
CREATE TABLE trace (
  presentation INTEGER PRIMARY KEY REFERENCES presentation_end (presentation),
  samples      INTEGER NOT NULL,
  sha256       TEXT NOT NULL,
  columns      BLOB NOT NULL
) STRICT;
CREATE TABLE ledger (
  entry         INTEGER PRIMARY KEY,
  previous_hash TEXT NOT NULL,
  hash          TEXT NOT NULL UNIQUE
) STRICT;
CREATE TABLE answer (
  entry           INTEGER PRIMARY KEY REFERENCES ledger (entry),
  session         INTEGER NOT NULL,
  trial           INTEGER NOT NULL,
  draw            INTEGER NOT NULL,
  response        INTEGER NOT NULL,
  correct         INTEGER NOT NULL CHECK (correct IN (0, 1)),
  response_time_s REAL,
  onset_utc       TEXT NOT NULL,
  committed_utc   TEXT NOT NULL,
  UNIQUE (session, trial),
  FOREIGN KEY (session, trial, draw) REFERENCES trial (session, number, draw)
) STRICT;
CREATE TABLE event (
  entry   INTEGER PRIMARY KEY REFERENCES ledger (entry),
  session INTEGER REFERENCES session (id),
  trial   INTEGER,
  kind    TEXT NOT NULL,
  text    TEXT NOT NULL,
  utc     TEXT NOT NULL
) STRICT;
)sql";

constexpr std::array kTableNames{
    "study", "study_file", "session", "trial", "presentation", "presentation_end",
    "trace", "ledger",     "answer",  "event"};

constexpr const char* kSolveTable = R"sql(
CREATE TABLE presentation_solve (
  presentation            INTEGER PRIMARY KEY REFERENCES presentation_end (presentation),
  force_error_bound_n     REAL NOT NULL,
  cycles_within_tolerance INTEGER NOT NULL,
  cycles_at_cap           INTEGER NOT NULL
) STRICT;
)sql";
constexpr const char* kSolveTableInMemory =
    "CREATE TEMP TABLE presentation_solve (presentation, force_error_bound_n, cycles_within_tolerance, "
    "cycles_at_cap)";

/// Rows are only ever added: a correction is an event of its own.
std::string append_only(const char* table, const char* action) {
  return fmt::format(
      "CREATE TRIGGER {0}_refuses_{1} BEFORE {1} ON {0} BEGIN SELECT RAISE(ABORT, 'rows of {0} are "
      "append-only'); END",
      table, action);
}

std::map<std::string, std::string> objects(SQLite::Database& database) {
  std::map<std::string, std::string> found;
  Query rows(database, "SELECT type || ' ' || name, coalesce(sql, '') FROM sqlite_schema");
  while (rows.next()) found[rows.text(0)] = rows.text(1);
  return found;
}

void refuse_changes(SQLite::Database& database, const char* table) {
  for (const char* action : {"UPDATE", "DELETE"}) database.exec(append_only(table, action));
}

void create_version_1(SQLite::Database& database) {
  database.exec(kTables);
  for (const char* table : kTableNames) refuse_changes(database, table);
}

/// How exactly the forces of a presentation were computed.
void add_solve_table(SQLite::Database& database) {
  database.exec(kSolveTable);
  refuse_changes(database, "presentation_solve");
}

using Step = void (*)(SQLite::Database&);
constexpr std::array<Step, kSchemaVersion> kSteps{create_version_1, add_solve_table};  // [v - 1] makes v

int version_of(SQLite::Database& database) {
  Query current(database, "PRAGMA user_version");
  current.next();
  return current.number(0);
}

}  // namespace

void create_schema(SQLite::Database& database) {
  for (const Step step : kSteps) step(database);
  database.exec(
      fmt::format("PRAGMA application_id = {}; PRAGMA user_version = {}", kApplicationId, kSchemaVersion));
}

void migrate(SQLite::Database& database) {
  for (int version = version_of(database); version < kSchemaVersion; ++version) {
    SQLite::Transaction transaction(database, SQLite::TransactionBehavior::IMMEDIATE);
    kSteps.at(version)(database);
    database.exec(fmt::format("PRAGMA user_version = {}", version + 1));
    transaction.commit();
  }
}

void supply_later_tables(SQLite::Database& database) {
  if (version_of(database) >= 2) return;
  database.exec("PRAGMA temp_store = MEMORY");
  database.exec(kSolveTableInMemory);
}

std::vector<std::string> schema_differences(SQLite::Database& database) {
  SQLite::Database fresh(":memory:", SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
  for (int version = 0; version < version_of(database); ++version) kSteps.at(version)(fresh);
  const auto expected = objects(fresh), found = objects(database);
  std::vector<std::string> differences;
  for (const auto& [name, sql] : expected) {
    const auto at = found.find(name);
    if (at == found.end())
      differences.push_back(fmt::format("schema: {} is missing", name));
    else if (at->second != sql)
      differences.push_back(fmt::format("schema: {} was changed", name));
  }
  for (const auto& [name, sql] : found)
    if (!expected.contains(name)) differences.push_back(fmt::format("schema: {} was added", name));
  return differences;
}

}  // namespace palpate::trials
