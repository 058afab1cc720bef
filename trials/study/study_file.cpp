#include "trials/study/study_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "base/clock/utc.hpp"
#include "trials/study/file_check.hpp"
#include "trials/study/lost_answers.hpp"
#include "trials/study/new_study.hpp"
#include "trials/study/schema.hpp"
#include "trials/study/stores.hpp"

namespace palpate::trials {
namespace {

StudyRow study_of(const Protocol& protocol, std::string_view software_version) {
  return {.uuid = fresh_uuid(),
          .created_utc = base::utc_now(),
          .protocol_name = protocol.name,
          .protocol_text = protocol.text,
          .protocol_sha256 = protocol.sha256,
          .scene_text = protocol.scene_text,
          .files = protocol.files,
          .software_version = std::string(software_version)};
}

void check_same_study(const std::filesystem::path& path, const StudyRow& study, const Protocol& protocol) {
  if (study.protocol_sha256 != protocol.sha256)
    throw std::invalid_argument(fmt::format(
        "{}: holds a study of protocol \"{}\" (SHA-256 {:.12}...), not of {} as it is now ({:.12}...); "
        "accepted: the protocol unchanged, or another study file",
        path.string(), study.protocol_name, study.protocol_sha256, protocol.file.string(), protocol.sha256));
  for (const FileHash& now : protocol.files) {
    const auto then = std::ranges::find(study.files, now.name, &FileHash::name);
    if (then == study.files.end() || then->sha256 != now.sha256)
      throw std::invalid_argument(fmt::format(
          "{}: {} ({}) is not the one that this study began with; accepted: the file unchanged, or "
          "another study file",
          path.string(), now.file.string(), now.name));
  }
}

}  // namespace

StudyFile::StudyFile(std::unique_ptr<Stores> stores) : stores_(std::move(stores)) {}
StudyFile::~StudyFile() = default;
StudyFile::StudyFile(StudyFile&&) noexcept = default;
StudyFile& StudyFile::operator=(StudyFile&&) noexcept = default;

const std::filesystem::path& StudyFile::path() const {
  return stores_->path;
}
StudyRow StudyFile::study() const {
  return stores_->study;
}
const Protocol& StudyFile::protocol() const {
  return stores_->design;
}

std::vector<SessionRow> StudyFile::sessions() const {
  return guarded(path(), [&] { return stores_->sessions.all(); });
}
std::vector<DrawnTrial> StudyFile::trials(std::int64_t session) const {
  return guarded(path(), [&] { return stores_->trials.of_session(session); });
}
std::vector<PresentationRow> StudyFile::presentations(std::int64_t session) const {
  return guarded(path(), [&] { return stores_->presentations.of_session(session); });
}
std::vector<AnswerRow> StudyFile::answers(std::int64_t session) const {
  return guarded(path(), [&] { return stores_->answers.of_session(session); });
}
std::vector<EventRow> StudyFile::events() const {
  return guarded(path(), [&] { return stores_->events.all(); });
}
Receipt StudyFile::receipt() const {
  return guarded(path(), [&] { return stores_->ledger.head(stores_->study); });
}

Trace StudyFile::load_trace(std::int64_t presentation) const {
  const auto stored = guarded(path(), [&] { return stores_->presentations.trace(presentation); });
  return stored ? decode(stored->first, stored->second) : Trace{};
}

void StudyFile::lock_for_sessions() {
  stores_->lock.acquire(path());
}

void StudyFile::add_event(const EventRow& event) {
  guarded(path(), [&] {
    SQLite::Transaction transaction(stores_->database, SQLite::TransactionBehavior::IMMEDIATE);
    stores_->append(event);
    transaction.commit();
    stores_->settle();
  });
}

void check_study(const std::filesystem::path& path, const Protocol& protocol) {
  check_writable(path);
  if (std::filesystem::exists(path)) check_same_study(path, read_study(path).study(), protocol);
}

StudyFile open_study(const std::filesystem::path& path, const Protocol& protocol,
                     std::string_view software_version) {
  check_study(path, protocol);
  const bool is_new = !std::filesystem::exists(path);
  if (is_new) {
    const StudyRow study = study_of(protocol, software_version);
    write_new_study(path, [&](SQLite::Database& database) { StudyStore(database).add(study); });
  }
  return guarded(path, [&] {
    auto stores = std::make_unique<StudyFile::Stores>(path, open_for_writing(path));
    migrate(stores->database);
    if (is_new)
      stores->settle();
    else if (const auto lost = lost_after_head(*stores, read_head(path)))
      throw std::invalid_argument(*lost);
    return StudyFile(std::move(stores));
  });
}

StudyFile read_study(const std::filesystem::path& path) {
  check_is_study_file(path);
  return guarded(
      path, [&] { return StudyFile(std::make_unique<StudyFile::Stores>(path, open_for_reading(path))); });
}

}  // namespace palpate::trials
