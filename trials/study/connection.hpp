#pragma once

#include <SQLiteCpp/SQLiteCpp.h>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace palpate::trials {

/// Opens for writing: foreign keys on, every commit flushed to the disk (synchronous=FULL), write-ahead log.
SQLite::Database open_for_writing(const std::filesystem::path& file);

/// Opens for reading; the file's bytes are not touched. See supply_later_tables() for an older one. Without a write-ahead log beside it (nobody has it
/// open, and nobody was killed while writing) not even an index file is made, so that a read-only folder will
/// do.
SQLite::Database open_for_reading(const std::filesystem::path& file);

/// Bytes of the write-ahead log beside a study file; 0 where there is none.
std::uintmax_t write_ahead_log_size(const std::filesystem::path& file);

/// Puts all that was committed into the database itself and empties the write-ahead log, unless a reader
/// still needs it. Outside any transaction.
void fold_in_log(SQLite::Database& database);

/// Whether SQLite found the file itself at fault: damaged, or a table or column missing.
bool is_damage(const SQLite::Exception& error);

/// What SQLite says, with the file and what it means: bad input when the file is damaged or no database
/// (std::invalid_argument), else a failure of the machine (std::runtime_error).
[[noreturn]] void rethrow(const SQLite::Exception& error, const std::filesystem::path& file);

/// Runs `action`, SQLite's errors told as rethrow() tells them.
template <class Action>
auto guarded(const std::filesystem::path& file, Action action) {
  try {
    return action();
  } catch (const SQLite::Exception& error) {
    rethrow(error, file);
  }
}

/// Bytes to be bound as a BLOB.
struct Blob {
  const std::string& bytes;
};

/// One statement with its values bound from the first on; an empty optional is NULL.
class Query {
 public:
  template <class... Values>
  explicit Query(SQLite::Database& database, const char* sql, const Values&... values)
      : statement_(database, sql) {
    int index = 0;
    (bind(++index, values), ...);
  }

  bool next() { return statement_.executeStep(); }
  void run() { statement_.exec(); }

  std::string text(int column) { return statement_.getColumn(column).getString(); }
  std::int64_t integer(int column) { return statement_.getColumn(column).getInt64(); }
  int number(int column) { return statement_.getColumn(column).getInt(); }
  double real(int column) { return statement_.getColumn(column).getDouble(); }
  bool is_null(int column) { return statement_.getColumn(column).isNull(); }
  std::string blob(int column) {
    const SQLite::Column found = statement_.getColumn(column);
    return {static_cast<const char*>(found.getBlob()), static_cast<std::size_t>(found.getBytes())};
  }
  std::optional<std::string> optional_text(int column) {
    return is_null(column) ? std::nullopt : std::optional(text(column));
  }
  std::optional<double> optional_real(int column) {
    return is_null(column) ? std::nullopt : std::optional(real(column));
  }
  std::optional<std::int64_t> optional_integer(int column) {
    return is_null(column) ? std::nullopt : std::optional(integer(column));
  }

 private:
  template <class Value>
  void bind(int index, const Value& value) {
    statement_.bind(index, value);
  }
  void bind(int index, const Blob& value) {
    statement_.bind(index, value.bytes.data(), static_cast<int>(value.bytes.size()));
  }
  void bind(int index, bool value) { statement_.bind(index, value ? 1 : 0); }
  template <class Value>
  void bind(int index, const std::optional<Value>& value) {
    if (value)
      bind(index, *value);
    else
      statement_.bind(index);
  }

  SQLite::Statement statement_;
};

}  // namespace palpate::trials
