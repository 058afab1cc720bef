#include "trials/study/new_study.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include "base/files/new_folder.hpp"
#include "trials/plan/random.hpp"
#include "trials/study/connection.hpp"
#include "trials/study/schema.hpp"

namespace palpate::trials {
namespace {

void flush_folder(const std::filesystem::path& file) {
  const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : ".";
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return;
  ::fsync(descriptor);
  ::close(descriptor);
}

}  // namespace

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
  flush_folder(path);
}

}  // namespace palpate::trials
