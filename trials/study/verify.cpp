#include "trials/study/verify.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <stdexcept>

#include "base/files/sha256.hpp"
#include "base/text/counted.hpp"
#include "base/text/utf8.hpp"
#include "trials/study/chain_parts.hpp"
#include "trials/study/file_check.hpp"
#include "trials/study/lost_answers.hpp"
#include "trials/study/schema.hpp"
#include "trials/study/stores.hpp"
#include "trials/study/verify_session.hpp"

namespace palpate::trials {
namespace {

void check_database(SQLite::Database& database, VerifyScope scope, FirstProblems& problems) {
  if (scope == VerifyScope::Everything) {
    Query integrity(database, "PRAGMA integrity_check(20)");
    while (integrity.next())
      if (const std::string said = integrity.text(0); said != "ok") problems.add("database: {}", said);
  }
  Query foreign(database, "PRAGMA foreign_key_check");
  while (foreign.next())
    problems.add("database: a row of {} refers to a row that is not there", foreign.text(0));
}

void check_identity(const StudyRow& study, FirstProblems& problems) {
  if (base::sha256_hex(study.protocol_text) != study.protocol_sha256)
    problems.add("study: the protocol's text does not have the hash that is stored with it");
  const auto scene = std::ranges::find(study.files, "scene", &FileHash::name);
  if (scene == study.files.end() || base::sha256_hex(study.scene_text) != scene->sha256)
    problems.add("study: the scene's text does not have the hash that is stored with it");
}

void check_chain(const StudyFile::Stores& stores, const ChainParts& chains,
                 const std::map<std::int64_t, std::string>& texts, FirstProblems& problems) {
  std::string previous;
  std::int64_t expected = 0;
  const auto ledger = stores.ledger.all();
  for (const LedgerEntry& entry : ledger) {
    if (entry.entry != ++expected) {
      problems.add("chain: entry {} is missing", expected);
      expected = entry.entry;
    }
    const auto& chain = chains.chain_of(entry.entry);
    if (entry.entry == chain.before + 1) previous = chain.genesis;
    const auto text = texts.find(entry.entry);
    if (entry.previous_hash != previous)
      problems.add("chain: entry {} does not follow the one before", entry.entry);
    if (text == texts.end())
      problems.add("chain: entry {} has lost its answer or event", entry.entry);
    else if (chain_hash(entry.previous_hash, text->second) != entry.hash)
      problems.add("chain: entry {} was altered: {}", entry.entry,
                   text->second.substr(0, text->second.find('\n')) + " and hash do not fit");
    previous = entry.hash;
  }
  if (texts.size() > ledger.size()) problems.add("chain: an answer or event stands outside the chain");
}

/// Each part still ends where it ended when the file was joined.
void check_parts(const ChainParts& chains, const std::vector<LedgerEntry>& ledger, FirstProblems& problems) {
  for (const auto& chain : chains.chains()) {
    if (!chain.part || chain.entries == 0) continue;
    const auto last = std::ranges::find(ledger, chain.before + chain.entries, &LedgerEntry::entry);
    if (last == ledger.end() || last->hash != chain.part->receipt.head)
      problems.add("chain: the part from {} does not end as it did when it was joined", chain.part->file);
  }
}

/// Whether one of the file's chains holds what the receipt was printed for. The file's own receipts count all
/// entries, a part's those of the part.
bool holds(const ChainParts& chains, const std::vector<LedgerEntry>& ledger, const Receipt& receipt) {
  return std::ranges::any_of(chains.chains(), [&](const ChainParts::Chain& chain) {
    if (receipt.entries == 0) return chain.genesis.starts_with(receipt.head);
    if (chain.part && receipt.entries > chain.entries) return false;
    const auto found =
        std::ranges::find(ledger, receipt.entries + (chain.part ? chain.before : 0), &LedgerEntry::entry);
    return found != ledger.end() && found->hash.starts_with(receipt.head);
  });
}

void check_receipt(const StudyFile::Stores& stores, const ChainParts& chains, const Receipt& receipt,
                   FirstProblems& problems) {
  const auto ledger = stores.ledger.all();
  if (holds(chains, ledger, receipt)) return;
  const std::string unless = "the receipt does not fit (a slip of the pen?)";
  if (receipt.entries == 0)
    problems.add("{}: if it is what was printed, this is another study", unless);
  else if (receipt.entries > static_cast<std::int64_t>(ledger.size()))
    problems.add(
        "{}: it was printed for {}, the file holds {}; if it is what was printed, the file was cut "
        "back or is another study's",
        unless, base::counted(receipt.entries, "entry", "entries"), ledger.size());
  else
    problems.add(
        "{}: entry {} is not the one that it was printed for; if it is what was printed, the file was "
        "rewritten or is another study's",
        unless, receipt.entries);
}

/// What the file was joined from; none, and a problem, when that cannot be read.
std::vector<MergedPart> read_parts(const std::vector<EventRow>& events, FirstProblems& problems) {
  try {
    return merged_parts(events);
  } catch (const std::invalid_argument& error) {
    problems.add("{}", error.what());
    return {};
  }
}

/// What verify_study() is to look at.
struct Asked {
  const std::filesystem::path& path;
  const std::optional<Receipt>& receipt;
  VerifyScope scope;
  HeadFile beside;  // read before the study: a sitting that goes on meanwhile only adds
};

/// All that needs the tables and the protocol to be readable.
void check_rows(const Asked& asked, SQLite::Database database, VerifyReport& report,
                FirstProblems& problems) {
  const auto& [path, receipt, scope, beside] = asked;
  check_database(database, scope, problems);
  check_identity(StudyStore(database).get(), problems);
  const StudyFile::Stores stores(path, std::move(database));
  if (stores.design.name != stores.study.protocol_name)
    problems.add("study: the protocol's name is \"{}\", its text says \"{}\"", stores.study.protocol_name,
                 stores.design.name);
  std::map<std::int64_t, std::string> texts, times;
  const auto events = stores.events.all();
  report.parts = read_parts(events, problems);
  const ChainParts chains(stores.study, report.parts);
  for (const EventRow& event : events) {
    texts[event.entry] = canonical_text(chains.as_hashed(event));
    times[event.entry] = event.utc;
    report.voided += event.kind == event_kind::kVoided ? 1 : 0;
  }
  for (const SessionRow& session : stores.sessions.all()) {
    check_session({stores, chains, events, session}, scope, texts, report, problems);
    for (const AnswerRow& answer : stores.answers.of_session(session.id))
      times[answer.entry] = answer.committed_utc;
  }
  report.clock_steps = clock_steps_back(times, chains);
  check_chain(stores, chains, texts, problems);
  check_parts(chains, stores.ledger.all(), problems);
  if (receipt) check_receipt(stores, chains, *receipt, problems);
  if (const auto lost = lost_after_head(stores, beside)) problems.add("{}", *lost);
  report.receipt = stores.ledger.head(stores.study);
}

std::vector<std::string> notes_on(const std::filesystem::path& path, const HeadFile& beside) {
  std::vector<std::string> notes;
  const std::string name = path.filename().string();
  if (const auto bytes = write_ahead_log_size(path); bytes > 0)
    notes.push_back(fmt::format(
        "{0}-wal ({1} bytes) holds what was written last and was read with it: whoever copies {0} copies both",
        name, bytes));
  if (beside.state == HeadFile::State::Unreadable)
    notes.push_back(fmt::format("{}.head cannot be read by this user and was not compared", name));
  return notes;
}

}  // namespace

VerifyReport verify_study(const std::filesystem::path& path, const std::optional<Receipt>& receipt,
                          VerifyScope scope) {
  check_is_study_file(path);
  VerifyReport report;
  FirstProblems problems;
  const Asked asked{path, receipt, scope, read_head(path)};
  report.notes = notes_on(path, asked.beside);
  guarded(path, [&] {
    std::vector<std::string> differences;
    try {
      SQLite::Database database = open_for_reading(path);
      database.exec("BEGIN");  // one snapshot: a sitting may go on meanwhile
      differences = schema_differences(database);
      for (const std::string& difference : differences) problems.add("{}", base::printable(difference));
      check_rows(asked, std::move(database), report, problems);
    } catch (const SQLite::Exception& error) {
      if (differences.empty() && !is_damage(error)) throw;
      problems.add("database: damaged, and the rest was not looked at ({})", base::printable(error.what()));
    } catch (const std::invalid_argument& error) {
      problems.add("the rest was not looked at: {}", error.what());
    }
  });
  report.problems = problems.take();
  return report;
}

void require_whole(const std::filesystem::path& study) {
  const auto problems = verify_study(study, {}, VerifyScope::Answers).problems;
  if (problems.empty()) return;
  throw std::invalid_argument(fmt::format(
      "{0}: the study file is not whole ({1}; the first: {2}); `palpate verify {0}` lists them",
      study.string(), base::counted(std::ssize(problems), "problem", "problems"), problems.front()));
}

}  // namespace palpate::trials
