#include "trials/study/connection.hpp"

#include <fmt/format.h>
#include <sqlite3.h>

#include <stdexcept>

#include "base/text/utf8.hpp"
#include "trials/study/schema.hpp"

namespace palpate::trials {
namespace {

constexpr int kWaitForOtherWriters = 5000;  // [ms]

/// The file's name as SQLite's URI form takes it.
std::string uri(const std::filesystem::path& file, std::string_view parameters) {
  std::string encoded = "file:";
  for (const char c : file.string())
    encoded += (c == '?' || c == '#' || c == '%') ? fmt::format("%{:02X}", static_cast<unsigned char>(c))
                                                  : std::string(1, c);
  return encoded + "?" + std::string(parameters);
}

/// Whether somebody may have it open, or was killed while writing: an open study's log can be empty, but its
/// index is there.
bool may_be_written(const std::filesystem::path& file) {
  std::error_code none;
  return write_ahead_log_size(file) > 0 || (std::filesystem::exists(file.string() + "-wal", none) &&
                                            std::filesystem::exists(file.string() + "-shm", none));
}

/// A write that the drive refuses takes nothing back of what was committed; of a read nothing is known.
std::string told_io_error(const SQLite::Exception& error, const std::filesystem::path& file) {
  const int what = error.getExtendedErrorCode();
  const bool writing =
      what == SQLITE_IOERR_WRITE || what == SQLITE_IOERR_FSYNC || what == SQLITE_IOERR_TRUNCATE;
  return fmt::format("{}: the drive refused to {} the study file ({}){}", file.string(),
                     writing ? "write" : "read or write", error.what(),
                     writing ? "; every answer given before is kept, see to the drive and start again" : "");
}

}  // namespace

SQLite::Database open_for_writing(const std::filesystem::path& file) {
  SQLite::Database database(file.string(), SQLite::OPEN_READWRITE, kWaitForOtherWriters);
  database.exec("PRAGMA foreign_keys = ON; PRAGMA synchronous = FULL; PRAGMA journal_mode = WAL");
  return database;
}

SQLite::Database open_for_reading(const std::filesystem::path& file) {
  const std::string name = uri(file, may_be_written(file) ? "mode=ro" : "mode=ro&immutable=1");
  SQLite::Database database(name, SQLite::OPEN_READONLY | SQLite::OPEN_URI, kWaitForOtherWriters);
  supply_later_tables(database);
  return database;
}

std::uintmax_t write_ahead_log_size(const std::filesystem::path& file) {
  std::error_code error;
  const auto size = std::filesystem::file_size(file.string() + "-wal", error);
  return error ? 0 : size;
}

void fold_in_log(SQLite::Database& database) {
  sqlite3* handle = database.getHandle();
  database.setBusyTimeout(0);  // a reader is not waited for: what it holds back is folded in the next time
  const int code = sqlite3_wal_checkpoint_v2(handle, nullptr, SQLITE_CHECKPOINT_TRUNCATE, nullptr, nullptr);
  database.setBusyTimeout(kWaitForOtherWriters);
  if (code != SQLITE_OK && code != SQLITE_BUSY && code != SQLITE_LOCKED)
    throw SQLite::Exception(handle, code);
}

bool is_damage(const SQLite::Exception& error) {
  const int code = error.getErrorCode();
  return code == SQLITE_CORRUPT || code == SQLITE_NOTADB || code == SQLITE_ERROR;
}

void rethrow(const SQLite::Exception& error, const std::filesystem::path& file) {
  const std::string said = base::printable(error.what());
  switch (error.getErrorCode()) {
    case SQLITE_CORRUPT:
    case SQLITE_NOTADB:
    case SQLITE_ERROR:  // its statements are ours and fit a whole file: a table or column is missing
      throw std::invalid_argument(fmt::format(
          "{}: the study file is damaged ({}); `palpate verify` tells more, a backup copy is needed",
          file.string(), said));
    case SQLITE_FULL:
      throw std::runtime_error(
          fmt::format("{}: the disk is full; every answer given before is kept, make room and start again",
                      file.string()));
    case SQLITE_IOERR:
      throw std::runtime_error(told_io_error(error, file));
    case SQLITE_CONSTRAINT:
      throw std::runtime_error(fmt::format(
          "{}: the study file refused a row that does not fit those it holds ({}), and nothing of "
          "this step was stored; another program wrote to it meanwhile, or it was altered: start "
          "again, and run `palpate verify` on it if this comes back",
          file.string(), said));
    case SQLITE_READONLY:
    case SQLITE_CANTOPEN:
    case SQLITE_PERM:
      throw std::runtime_error(
          fmt::format("{}: the study file or its folder cannot be written ({})", file.string(), said));
    case SQLITE_BUSY:
    case SQLITE_LOCKED:
      throw std::runtime_error(
          fmt::format("{}: another program keeps the study file locked ({})", file.string(), said));
    default:
      throw std::runtime_error(fmt::format("{}: the study file failed ({})", file.string(), said));
  }
}

}  // namespace palpate::trials
