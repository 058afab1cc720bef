#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <stdexcept>

#include "sim/io/sha256.hpp"
#include "trials/chain_parts.hpp"
#include "trials/session_state.hpp"
#include "trials/store/file_check.hpp"
#include "trials/store/schema.hpp"
#include "trials/store/stores.hpp"

namespace palpate::trials {
namespace {

constexpr std::size_t kMostProblems = 100;  // enough to see what happened

class Problems {
 public:
  template <class... Values>
  void add(fmt::format_string<Values...> format, Values&&... values) {
    if (found_.size() < kMostProblems) found_.push_back(fmt::format(format, std::forward<Values>(values)...));
  }
  std::vector<std::string> take() { return std::move(found_); }

 private:
  std::vector<std::string> found_;
};

void check_database(SQLite::Database& database, VerifyScope scope, Problems& problems) {
  if (scope == VerifyScope::Everything) {
    Query integrity(database, "PRAGMA integrity_check(20)");
    while (integrity.next())
      if (const std::string said = integrity.text(0); said != "ok") problems.add("database: {}", said);
  }
  Query foreign(database, "PRAGMA foreign_key_check");
  while (foreign.next())
    problems.add("database: a row of {} refers to a row that is not there", foreign.text(0));
}

void check_identity(const StudyRow& study, Problems& problems) {
  if (sim::sha256_hex(study.protocol_text) != study.protocol_sha256)
    problems.add("study: the protocol's text does not have the hash that is stored with it");
  const auto scene = std::ranges::find(study.files, "scene", &FileHash::name);
  if (scene == study.files.end() || sim::sha256_hex(study.scene_text) != scene->sha256)
    problems.add("study: the scene's text does not have the hash that is stored with it");
}

void check_trace(const StudyFile::Stores& stores, const std::string& place, const PresentationRow& p,
                 Problems& problems) {
  const auto stored = stores.presentations.trace(p.id);
  if (!stored) return problems.add("{}: its trace is missing", place);
  if (sim::sha256_hex(stored->first) != p.trace_sha256)
    return problems.add("{}: its trace does not have the hash that is stored with it", place);
  try {
    const ExplorationSummary summary = summarise(decode(stored->first, stored->second));
    if (summary.presses != p.exploration.presses || summary.peak_force != p.exploration.peak_force ||
        summary.max_depth != p.exploration.max_depth || summary.time != p.exploration.time)
      problems.add("{}: presses, time, force or depth are not those of its trace", place);
  } catch (const std::invalid_argument& error) {
    problems.add("{}: {}", place, error.what());
  }
}

/// The trial against the plan that was drawn, and what was shown against the trial.
void check_answer(const Protocol& design, const std::string& place, const DrawnTrial& drawn,
                  const std::vector<PresentationRow>& felt, const AnswerRow& answer, Problems& problems) {
  const auto& order = drawn.trial.interval_condition;
  const auto holds = std::ranges::find(order, design.correct);
  if (holds == order.end() || drawn.trial.correct_interval != 1 + (holds - order.begin()))
    problems.add("{}: the correct interval is not the one that held the correct condition", place);
  if (answer.correct != (answer.response == drawn.trial.correct_interval))
    problems.add("{}: whether the answer is correct does not follow from the order", place);
  for (std::size_t i = 0; i < order.size(); ++i) {
    const std::string& name = design.conditions[order[i]].name;
    const bool shown = std::ranges::any_of(felt, [&](const PresentationRow& p) {
      return p.interval == static_cast<int>(i + 1) && p.condition == name &&
             p.verdict == to_string(Verdict::Enough);
    });
    if (!shown) problems.add("{}: interval {} was never shown as drawn and explored enough", place, i + 1);
  }
}

/// Checks one sitting and gathers the text of each of its answers, by entry of the chain.
void check_session(const StudyFile::Stores& stores, const ChainParts& chains, const SessionRow& session,
                   VerifyScope scope, std::map<std::int64_t, std::string>& texts, VerifyReport& report,
                   Problems& problems) {
  const std::string who = fmt::format("examinee {}, sitting {}", session.facts.examinee, session.number);
  const auto trials = stores.trials.of_session(session.id);
  const auto presentations = stores.presentations.of_session(session.id);
  const auto answers = stores.answers.of_session(session.id);
  for (const PresentationRow& p : presentations)
    if (p.complete && scope == VerifyScope::Everything)
      check_trace(stores, fmt::format("{}, trial {}, interval {}", who, p.trial, p.interval), p, problems);
  for (const AnswerRow& answer : answers) {
    const std::string place = fmt::format("{}, trial {}", who, answer.trial);
    const auto drawn = std::ranges::find_if(trials, [&](const DrawnTrial& trial) {
      return trial.trial.number == answer.trial && trial.draw == answer.draw;
    });
    if (drawn == trials.end()) {
      problems.add("{}: is answered but was never drawn", place);
      continue;
    }
    const auto felt = presentations_of(presentations, *drawn);
    check_answer(stores.design, place, *drawn, felt, answer, problems);
    texts[answer.entry] =
        canonical_text(stores.design, chains.as_hashed(session, answer.entry), *drawn, felt, answer);
  }
  if (session.ended_utc && static_cast<int>(answers.size()) != trials_per_session(stores.design))
    problems.add("{}: has ended with {} answers of {}", who, answers.size(),
                 trials_per_session(stores.design));
  report.answers += static_cast<int>(answers.size());
  report.presentations += static_cast<int>(presentations.size());
}

void check_chain(const StudyFile::Stores& stores, const ChainParts& chains,
                 const std::map<std::int64_t, std::string>& texts, Problems& problems) {
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
void check_parts(const ChainParts& chains, const std::vector<LedgerEntry>& ledger, Problems& problems) {
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
    if (receipt.entries == 0) return receipt.head == chain.genesis;
    if (chain.part && receipt.entries > chain.entries) return false;
    const auto found =
        std::ranges::find(ledger, receipt.entries + (chain.part ? chain.before : 0), &LedgerEntry::entry);
    return found != ledger.end() && found->hash == receipt.head;
  });
}

void check_receipt(const StudyFile::Stores& stores, const ChainParts& chains, const Receipt& receipt,
                   Problems& problems) {
  const auto ledger = stores.ledger.all();
  if (holds(chains, ledger, receipt)) return;
  if (receipt.entries == 0)
    problems.add("receipt: was printed for another study");
  else if (receipt.entries > static_cast<std::int64_t>(ledger.size()))
    problems.add(
        "receipt: was printed for {} entries, the file holds {}: it was cut back or is another study's",
        receipt.entries, ledger.size());
  else
    problems.add(
        "receipt: entry {} is not the one that the receipt was printed for: the file was rewritten or is "
        "another study's",
        receipt.entries);
}

/// What the file was joined from; none, and a problem, when that cannot be read.
std::vector<MergedPart> read_parts(const std::vector<EventRow>& events, Problems& problems) {
  try {
    return merged_parts(events);
  } catch (const std::invalid_argument& error) {
    problems.add("{}", error.what());
    return {};
  }
}

/// All that needs the tables and the protocol to be readable.
void check_rows(const std::filesystem::path& path, SQLite::Database database,
                const std::optional<Receipt>& receipt, VerifyScope scope, VerifyReport& report,
                Problems& problems) {
  check_database(database, scope, problems);
  check_identity(StudyStore(database).get(), problems);
  const StudyFile::Stores stores(path, std::move(database));
  std::map<std::int64_t, std::string> texts;
  const auto events = stores.events.all();
  report.parts = read_parts(events, problems);
  const ChainParts chains(stores.study, report.parts);
  for (const EventRow& event : events) {
    texts[event.entry] = canonical_text(chains.as_hashed(event));
    report.voided += event.kind == event_kind::kVoided ? 1 : 0;
  }
  for (const SessionRow& session : stores.sessions.all()) {
    check_session(stores, chains, session, scope, texts, report, problems);
    ++report.sessions;
  }
  check_chain(stores, chains, texts, problems);
  check_parts(chains, stores.ledger.all(), problems);
  if (receipt) check_receipt(stores, chains, *receipt, problems);
  report.receipt = stores.ledger.head(stores.study);
}

}  // namespace

VerifyReport verify_study(const std::filesystem::path& path, const std::optional<Receipt>& receipt,
                          VerifyScope scope) {
  check_is_study_file(path);
  VerifyReport report;
  Problems problems;
  guarded(path, [&] {
    SQLite::Database database = open_for_reading(path);
    database.exec("BEGIN");  // one snapshot: a sitting may go on meanwhile
    const auto differences = schema_differences(database);
    for (const std::string& difference : differences) problems.add("{}", difference);
    try {
      check_rows(path, std::move(database), receipt, scope, report, problems);
    } catch (const SQLite::Exception& error) {
      if (differences.empty()) throw;
      problems.add("schema: the rest was not looked at ({})", error.what());
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
      "{0}: the study file is not whole ({1} problem{2}; the first: {3}); `palpate verify {0}` lists them",
      study.string(), problems.size(), problems.size() == 1 ? "" : "s", problems.front()));
}

}  // namespace palpate::trials
