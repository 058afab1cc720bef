#pragma once

#include <SQLiteCpp/Database.h>

#include <cstdint>
#include <string>
#include <vector>

namespace palpate::trials {

constexpr std::int32_t kApplicationId = 0x70616C70;  // "palp", at byte 68 of the file
constexpr int kSchemaVersion = 2;                    // user_version, at byte 60

/// Makes the tables of version kSchemaVersion in an empty database.
void create_schema(SQLite::Database& database);

/// Brings an older file forward, one version a step, each in a transaction. A newer one was refused before.
void migrate(SQLite::Database& database);

/// An older file that is opened for reading is not brought forward: beside it, in memory, come the tables that
/// it lacks, empty, so that one statement reads every version.
void supply_later_tables(SQLite::Database& database);

/// Differences between the tables, indexes and triggers of a file and those of its version; empty when it is
/// whole.
std::vector<std::string> schema_differences(SQLite::Database& database);

}  // namespace palpate::trials
