#pragma once

#include <sqlite3.h>

#include <filesystem>
#include <string>

namespace palpate::trials::test {

/// Runs SQL on a file behind the program's back; returns SQLite's error message, empty when there is none.
inline std::string sql(const std::filesystem::path& file, const std::string& text) {
  sqlite3* database = nullptr;
  sqlite3_open(file.c_str(), &database);
  char* error = nullptr;
  sqlite3_exec(database, text.c_str(), nullptr, nullptr, &error);
  const std::string message = error ? error : "";
  sqlite3_free(error);
  sqlite3_close(database);
  return message;
}

/// The first column of the first row.
inline std::string sql_value(const std::filesystem::path& file, const std::string& text) {
  sqlite3* database = nullptr;
  sqlite3_open(file.c_str(), &database);
  std::string value;
  sqlite3_exec(
      database, text.c_str(),
      [](void* to, int, char** columns, char**) {
        *static_cast<std::string*>(to) = columns[0] ? columns[0] : "";
        return 0;
      },
      &value, nullptr);
  sqlite3_close(database);
  return value;
}

}  // namespace palpate::trials::test
