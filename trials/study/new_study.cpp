#include "trials/study/new_study.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include "base/files/flush_folder.hpp"
#include "base/files/new_folder.hpp"
#include "trials/plan/random.hpp"
#include "trials/study/connection.hpp"
#include "trials/study/schema.hpp"

namespace palpate::trials {
std::string fresh_uuid() {
  Generator generator = make_generator({}, "identity of a study");
  return fmt::format("{:016x}{:016x}", generator.next(), generator.next());
}

void write_new_study(const std::filesystem::path& path, const std::function<void(SQLite::Database&)>& fill,
                     const std::function<void(const std::filesystem::path& aside)>& inspect) {
  const std::filesystem::path aside = fmt::format("{}.new-{}", path.string(), ::getpid());
  try {
    guarded(path, [&] {
      SQLite::Database database(aside.string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
      database.exec("PRAGMA synchronous = FULL; PRAGMA foreign_keys = ON");
      SQLite::Transaction transaction(database);
      create_schema(database);
      fill(database);
      transaction.commit();
    });
    if (inspect) inspect(aside);
    base::rename_new(aside, path);
  } catch (...) {
    std::error_code ignored;
    std::filesystem::remove(aside, ignored);
    std::filesystem::remove(aside.string() + "-journal", ignored);
    throw;
  }
  base::flush_folder(path);
}

}  // namespace palpate::trials
