#include "trials/study/merge.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <stdexcept>

#include "base/clock/utc.hpp"
#include "base/text/counted.hpp"
#include "trials/study/chain_parts.hpp"
#include "trials/study/examinee_code.hpp"
#include "trials/study/file_check.hpp"
#include "trials/study/head_file.hpp"
#include "trials/study/new_study.hpp"
#include "trials/study/stores.hpp"
#include "trials/study/verify.hpp"

namespace palpate::trials {
namespace {

struct Source {
  MergeSource asked{};
  std::unique_ptr<StudyFile::Stores> stores{};
  const StudyRow& study() const { return stores->study; }
};

template <class... Values>
[[noreturn]] void refuse(fmt::format_string<Values...> format, Values&&... values) {
  throw std::invalid_argument(fmt::format(format, std::forward<Values>(values)...));
}

Source open_source(const MergeSource& asked) {
  const bool fits = std::ranges::all_of(asked.site, [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
  });
  if (!fits) refuse("site \"{}\"; accepted: letters and digits", asked.site);
  const VerifyReport report = verify_study(asked.file);
  const std::string name = asked.file.string();
  if (!report.problems.empty())
    refuse("{}: is not whole and is not joined: {}; `palpate verify` tells more", name,
           report.problems.front());
  if (!report.parts.empty())
    refuse("{}: was itself joined from others; accepted: the sites' own files, all at once", name);
  return {asked, std::make_unique<StudyFile::Stores>(asked.file, open_for_reading(asked.file))};
}

/// The same design on the same scene and meshes, and not the same study twice.
void check_fit(const Source& first, const Source& other) {
  const std::string a = first.asked.file.string(), b = other.asked.file.string();
  if (first.study().protocol_sha256 != other.study().protocol_sha256)
    refuse("{} holds the protocol with SHA-256 {}, {} that with {}; accepted: study files of one protocol", a,
           first.study().protocol_sha256, b, other.study().protocol_sha256);
  if (first.study().uuid == other.study().uuid)
    refuse("{} and {} are the same study, {}; accepted: every study once", a, b, first.study().uuid);
  for (const FileHash& file : first.study().files) {
    const auto same = std::ranges::find(other.study().files, file.name, &FileHash::name);
    const std::string hash = same == other.study().files.end() ? "none" : same->sha256;
    if (hash != file.sha256)
      refuse(
          "{} was run on the file {} ({}) with SHA-256 {}, {} with {}; accepted: study files run on the same "
          "files",
          a, file.file.string(), file.name, file.sha256, b, hash);
  }
}

void check_codes(const std::vector<Source>& sources) {
  struct Owner {
    std::string code;
    const Source* source;
  };
  std::map<std::string, Owner> owners;  // by what the code reads like
  for (const Source& source : sources)
    for (const SessionRow& session : source.stores->sessions.all()) {
      const std::string code = code_at_site(source.asked.site, session.facts.examinee);
      check_examinee_code(code);
      const auto [owner, is_new] = owners.emplace(normal_form(code), Owner{code, &source});
      if (!is_new && owner->second.source != &source)
        refuse(
            "examinee {} of {} reads like {} of {}; accepted: codes that differ, or a name for each site "
            "(--site NAME=FILE), which is put before its codes",
            code, source.asked.file.string(), owner->second.code, owner->second.source->asked.file.string());
    }
}

void check_sources(const std::vector<Source>& sources) {
  if (sources.size() < 2)
    refuse("{} to join; accepted: two or more",
           base::counted(std::ssize(sources), "study file", "study files"));
  for (std::size_t i = 0; i < sources.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) check_fit(sources[j], sources[i]);
  check_codes(sources);
}

/// Writes into a new study file, source by source.
class Merger {
 public:
  Merger(SQLite::Database& database, const Protocol& design) : database_(database), design_(design) {}

  void add(const Source& source) {
    SQLite::Transaction snapshot(source.stores->database);  // a sitting may go on meanwhile
    const auto sessions = source.stores->sessions.all();
    const auto ledger = source.stores->ledger.all();
    for (const LedgerEntry& entry : ledger)
      ledger_.add({entries_ + entry.entry, entry.previous_hash, entry.hash});
    for (const SessionRow& session : sessions) add_session(source, session);
    for (EventRow event : source.stores->events.all()) {
      if (event.session) *event.session += sessions_;
      events_.add(entries_ + event.entry, event);
    }
    parts_.push_back({.site = source.asked.site,
                      .file = source.asked.file.filename().string(),
                      .uuid = source.study().uuid,
                      .created_utc = source.study().created_utc,
                      .software_version = source.study().software_version,
                      .sessions = static_cast<std::int64_t>(sessions.size()),
                      .receipt = source.stores->ledger.head(source.study())});
    sessions_ += static_cast<std::int64_t>(sessions.size());
    entries_ += static_cast<std::int64_t>(ledger.size());
  }

  /// The file's own chain begins with what it was joined from.
  void finish(const StudyRow& study) {
    EventRow event{
        .kind = std::string(event_kind::kMerged), .text = merged_text(parts_), .utc = base::utc_now()};
    const std::string beginning = genesis(study);
    ledger_.add({entries_ + 1, beginning, chain_hash(beginning, canonical_text(event))});
    events_.add(entries_ + 1, event);
  }

 private:
  void add_session(const Source& source, const SessionRow& session) {
    SessionRow row = session;
    row.facts.examinee = code_at_site(source.asked.site, session.facts.examinee);
    const std::int64_t id = sessions_store_.add(row);
    if (id != sessions_ + session.id)
      refuse("{}: the study file is damaged: its sittings are not numbered 1, 2, 3",
             source.asked.file.string());
    for (DrawnTrial trial : source.stores->trials.of_session(session.id)) {
      trial.session = id;
      trials_.add(trial);
    }
    for (PresentationRow p : source.stores->presentations.of_session(session.id)) {
      const auto trace = source.stores->presentations.trace(p.id);
      p.session = id;
      p.id = presentations_.begin(p);
      if (p.closed()) presentations_.end(p, trace ? trace->first : std::string());
    }
    for (AnswerRow answer : source.stores->answers.of_session(session.id)) {
      answer.session = id;
      answers_.add(entries_ + answer.entry, answer);
    }
  }

  SQLite::Database& database_;
  const Protocol& design_;
  LedgerStore ledger_{database_};
  SessionStore sessions_store_{database_};
  TrialStore trials_{database_, design_};
  PresentationStore presentations_{database_, design_};
  AnswerStore answers_{database_};
  EventStore events_{database_};
  std::int64_t sessions_ = 0, entries_ = 0;  // added before the current source
  std::vector<MergedPart> parts_{};
};

}  // namespace

void merge_studies(const std::filesystem::path& out, const std::vector<MergeSource>& asked,
                   std::string_view software_version) {
  if (std::filesystem::exists(out))
    refuse(
        "{}: is there already and is not overwritten; accepted: a new name, before those of the study files",
        out.string());
  check_writable(out);
  std::vector<Source> sources;
  sources.reserve(asked.size());
  for (const MergeSource& source : asked) sources.push_back(open_source(source));
  check_sources(sources);
  StudyRow study = sources.front().study();
  study.uuid = fresh_uuid();
  study.created_utc = base::utc_now();
  study.software_version = software_version;
  const auto fill = [&](SQLite::Database& database) {
    StudyStore(database).add(study);
    Merger merger(database, sources.front().stores->design);
    for (const Source& source : sources) merger.add(source);
    merger.finish(study);
  };
  Receipt receipt;
  const auto inspect = [&](const std::filesystem::path& aside) {
    const VerifyReport report = verify_study(aside);
    receipt = report.receipt;
    if (!report.problems.empty())
      throw std::runtime_error(fmt::format("{}: the joined file would not be whole, and was not made: {}",
                                           out.string(), report.problems.front()));
  };
  write_new_study(out, fill, inspect);
  write_head(out, {study.uuid, receipt});
}

}  // namespace palpate::trials
