#include "trials/study/presentation_store.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "trials/study/named.hpp"

namespace palpate::trials {
namespace {

Verdict verdict_of(const std::string& stored) {
  try {
    return verdict_from(stored);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(fmt::format("the study file is damaged: a presentation's {}", error.what()));
  }
}

}  // namespace

std::int64_t PresentationStore::begin(const PresentationRow& p) {
  Query(database_,
        "INSERT INTO presentation (session, trial, draw, interval, attempt, condition, begun_utc) "
        "VALUES (?, ?, ?, ?, ?, ?, ?)",
        p.session, p.trial, p.draw, p.interval, p.attempt, design_.conditions.at(p.condition).name,
        p.begun_utc)
      .run();
  return database_.getLastInsertRowid();
}

void PresentationStore::end(const PresentationRow& p, const std::string& encoded_trace) {
  std::optional<double> rate, p999;
  std::optional<std::int64_t> missed;
  if (p.loop) {
    rate = p.loop->rate_hz;
    p999 = p.loop->p999_ms;
    missed = p.loop->missed_cycles;
  }
  Query(database_,
        "INSERT INTO presentation_end (presentation, onset_utc, verdict, n_presses, exploration_time_s, "
        "peak_force_n, max_depth_m, clamped_fraction, loop_rate_hz, loop_p999_ms, missed_cycles) "
        "VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)",
        p.id, p.onset_utc, std::string(to_string(p.verdict.value())), p.exploration.presses,
        p.exploration.time, p.exploration.peak_force, p.exploration.max_depth, p.clamped_fraction, rate, p999,
        missed)
      .run();
  Query(database_, "INSERT INTO trace (presentation, samples, sha256, columns) VALUES (?, ?, ?, ?)", p.id,
        static_cast<std::int64_t>(p.samples), p.trace_sha256, Blob{encoded_trace})
      .run();
  if (!p.solve) return;
  Query(database_,
        "INSERT INTO presentation_solve (presentation, force_error_bound_n, cycles_within_tolerance, "
        "cycles_at_cap) VALUES (?, ?, ?, ?)",
        p.id, p.solve->force_error_bound, std::int64_t{p.solve->cycles_within_tolerance},
        std::int64_t{p.solve->cycles_at_cap})
      .run();
}

std::vector<PresentationRow> PresentationStore::of_session(std::int64_t session) const {
  std::vector<PresentationRow> found;
  Query rows(
      database_,
      "SELECT id, trial, draw, interval, attempt, condition, begun_utc, onset_utc, verdict, n_presses, "
      "exploration_time_s, peak_force_n, max_depth_m, clamped_fraction, loop_rate_hz, loop_p999_ms, "
      "missed_cycles, samples, sha256, force_error_bound_n, cycles_within_tolerance, cycles_at_cap FROM "
      "presentation LEFT JOIN presentation_end ON presentation_end.presentation = id LEFT JOIN trace ON "
      "trace.presentation = id LEFT JOIN presentation_solve ON presentation_solve.presentation = id WHERE "
      "session = ? ORDER BY id",
      session);
  while (rows.next()) {
    PresentationRow p;
    p.id = rows.integer(0);
    p.session = session;
    p.trial = rows.number(1);
    p.draw = rows.number(2);
    p.interval = rows.number(3);
    p.attempt = rows.number(4);
    p.condition = index_of(design_.conditions, rows.text(5), "a presentation");
    p.begun_utc = rows.text(6);
    if (!rows.is_null(7)) {
      p.onset_utc = rows.text(7);
      p.verdict = verdict_of(rows.text(8));
      p.exploration = {rows.number(9), rows.real(10), rows.real(11), rows.real(12)};
      p.clamped_fraction = rows.real(13);
      if (!rows.is_null(14)) p.loop = LoopTiming{rows.real(14), rows.real(15), rows.integer(16)};
      p.samples = rows.integer(17);
      p.trace_sha256 = rows.text(18);
      if (!rows.is_null(19)) p.solve = SolveRecord{rows.real(19), rows.integer(20), rows.integer(21)};
    }
    found.push_back(std::move(p));
  }
  return found;
}

std::optional<std::pair<std::string, std::size_t>> PresentationStore::trace(std::int64_t presentation) const {
  Query row(database_, "SELECT columns, samples FROM trace WHERE presentation = ?", presentation);
  if (!row.next()) return std::nullopt;
  return std::pair{row.blob(0), static_cast<std::size_t>(row.integer(1))};
}

}  // namespace palpate::trials
