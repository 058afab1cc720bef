#include "trials/study/ledger_store.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/files/sha256.hpp"

namespace palpate::trials {
namespace {

/// One value a line: line breaks and backslashes inside a value are escaped, so that two different rows never
/// have one text.
void add(std::string& text, std::string_view name, std::string_view value) {
  text += name;
  text += '=';
  for (const char c : value) {
    if (c == '\\')
      text += "\\\\";
    else if (c == '\n')
      text += "\\n";
    else
      text += c;
  }
  text += '\n';
}

void add(std::string& text, std::string_view name, const std::optional<double>& value) {
  add(text, name, value ? fmt::format("{}", *value) : std::string("null"));
}

void add(std::string& text, std::string_view name, std::int64_t value) {
  add(text, name, std::string_view(fmt::format("{}", value)));
}

void add(std::string& text, const Protocol& design, const PresentationRow& felt) {
  add(text, "interval", felt.interval);
  add(text, "attempt", felt.attempt);
  add(text, "condition", design.conditions.at(felt.condition).name);
  add(text, "begun", felt.begun_utc);
  add(text, "onset", felt.onset_utc);
  add(text, "verdict", felt.verdict ? to_string(*felt.verdict) : std::string_view());
  add(text, "presses", felt.exploration.presses);
  add(text, "time", std::optional(felt.exploration.time));
  add(text, "peak force", std::optional(felt.exploration.peak_force));
  add(text, "max depth", std::optional(felt.exploration.max_depth));
  add(text, "clamped", std::optional(felt.clamped_fraction));
  add(text, "loop rate", felt.loop ? std::optional(felt.loop->rate_hz) : std::nullopt);
  add(text, "loop p999", felt.loop ? std::optional(felt.loop->p999_ms) : std::nullopt);
  add(text, "missed", felt.loop ? felt.loop->missed_cycles : -1);
  if (felt.solve) {  // without it the text is that of version 1 of the study file, whose hashes stay right
    add(text, "force bound", std::optional(felt.solve->force_error_bound));
    add(text, "within tolerance", felt.solve->cycles_within_tolerance);
    add(text, "at cap", felt.solve->cycles_at_cap);
  }
  add(text, "samples", static_cast<std::int64_t>(felt.samples));
  add(text, "trace", felt.trace_sha256);
}

void add(std::string& text, const SessionRow& session) {
  add(text, "examinee", session.facts.examinee);
  add(text, "sitting", session.number);
  add(text, "run mode", to_string(session.facts.run_mode));
  add(text, "started", session.started_utc);
  add(text, "version", session.facts.software_version);
  add(text, "machine", session.facts.machine);
  add(text, "device", session.facts.device);
  add(text, "pseudo-haptic", session.facts.pseudo_haptic ? 1 : 0);
  add(text, "channel", session.facts.channel);
  add(text, "force scale", std::optional(session.facts.force_scale));
  add(text, "seed", session.facts.seed ? fmt::format("{}", *session.facts.seed) : std::string("entropy"));
  add(text, "observer", session.facts.observer.value_or("null"));
}

void add(std::string& text, const Protocol& design, const DrawnTrial& drawn) {
  std::vector<std::string> order;
  for (const std::size_t condition : drawn.trial.interval_condition)
    order.push_back(design.conditions.at(condition).name);
  add(text, "trial", drawn.trial.number);
  add(text, "draw", drawn.draw);
  add(text, "block", drawn.trial.block);
  add(text, "cell", design.cells.at(drawn.trial.cell).name);
  add(text, "order", fmt::format("{}", fmt::join(order, ",")));
  add(text, "correct interval", drawn.trial.correct_answer);
}

}  // namespace

// Without the files' names: two sites may keep one scene or mesh, the same bytes, under different names, and
// their joined file keeps the first site's. What a file is, is its hash; the name is only shown.
std::string genesis(const StudyRow& study) {
  std::string text = "palpate study 1\n";
  add(text, "uuid", study.uuid);
  add(text, "created", study.created_utc);
  add(text, "protocol", study.protocol_sha256);
  add(text, "version", study.software_version);
  for (const FileHash& file : study.files) add(text, file.name, file.sha256);
  return base::sha256_hex(text);
}

std::string chain_hash(std::string_view previous_hash, std::string_view text) {
  return base::sha256_hex(fmt::format("{}\n{}", previous_hash, text));
}

std::string canonical_text(const Protocol& design, const SessionRow& session, const DrawnTrial& drawn,
                           const std::vector<PresentationRow>& felt, const AnswerRow& answer) {
  std::string text = "answer\n";
  add(text, session);
  add(text, design, drawn);
  for (const PresentationRow& presentation : felt) add(text, design, presentation);
  add(text, "response", answer.response);
  add(text, "correct", answer.correct ? 1 : 0);
  add(text, "response time", answer.response_time);
  add(text, "question onset", answer.onset_utc);
  add(text, "committed", answer.committed_utc);
  return text;
}

std::string canonical_text(const EventRow& event) {
  std::string text = "event\n";
  add(text, "session", event.session.value_or(-1));
  add(text, "trial", event.trial.value_or(-1));
  add(text, "kind", event.kind);
  add(text, "text", event.text);
  add(text, "utc", event.utc);
  return text;
}

std::string begun_text(const Protocol& design, const SessionRow& session,
                       const std::vector<DrawnTrial>& plan) {
  std::string orders;
  for (const DrawnTrial& drawn : plan) add(orders, design, drawn);
  std::string text;
  add(text, session);
  add(text, "trials", static_cast<std::int64_t>(plan.size()));
  add(text, "plan", base::sha256_hex(orders));
  return text;
}

std::string drawn_again_text(const Protocol& design, const DrawnTrial& next,
                             const std::vector<PresentationRow>& felt_before) {
  std::string exposure;
  for (const PresentationRow& presentation : felt_before) add(exposure, design, presentation);
  std::string text;
  add(text, design, next);
  add(text, "presentations before", static_cast<std::int64_t>(felt_before.size()));
  add(text, "felt before", base::sha256_hex(exposure));
  return text;
}

Receipt LedgerStore::head(const StudyRow& study) const {
  Query last(database_, "SELECT entry, hash FROM ledger ORDER BY entry DESC LIMIT 1");
  if (!last.next()) return {.entries = 0, .head = genesis(study)};
  return {.entries = last.integer(0), .head = last.text(1)};
}

std::int64_t LedgerStore::append(const StudyRow& study, std::string_view text) {
  const Receipt before = head(study);
  const std::int64_t entry = before.entries + 1;
  add({entry, before.head, chain_hash(before.head, text)});
  return entry;
}

void LedgerStore::add(const LedgerEntry& entry) {
  Query(database_, "INSERT INTO ledger (entry, previous_hash, hash) VALUES (?, ?, ?)", entry.entry,
        entry.previous_hash, entry.hash)
      .run();
}

std::vector<LedgerEntry> LedgerStore::all() const {
  std::vector<LedgerEntry> entries;
  Query rows(database_, "SELECT entry, previous_hash, hash FROM ledger ORDER BY entry");
  while (rows.next()) entries.push_back({rows.integer(0), rows.text(1), rows.text(2)});
  return entries;
}

}  // namespace palpate::trials
