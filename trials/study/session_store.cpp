#include "trials/study/session_store.hpp"

#include <fmt/format.h>

#include <charconv>
#include <stdexcept>

namespace palpate::trials {
namespace {

std::uint64_t seed_from(const std::string& text) {
  std::uint64_t seed = 0;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), seed);
  if (read.ec != std::errc() || read.ptr != text.data() + text.size())
    throw std::invalid_argument(
        fmt::format("the study file is damaged: a sitting has the seed \"{}\"", text));
  return seed;
}

}  // namespace

std::int64_t SessionStore::add(const SessionRow& session) {
  const SessionFacts& facts = session.facts;
  const auto seed = facts.seed ? std::optional(fmt::format("{}", *facts.seed)) : std::nullopt;
  Query(database_,
        "INSERT INTO session (examinee, number, run_mode, started_utc, software_version, machine, device, "
        "pseudo_haptic, channel, force_scale, seed, observer) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)",
        facts.examinee, session.number, std::string(to_string(facts.run_mode)), session.started_utc,
        facts.software_version, facts.machine, facts.device, facts.pseudo_haptic, facts.channel,
        facts.force_scale, seed, facts.observer)
      .run();
  return database_.getLastInsertRowid();
}

std::vector<SessionRow> SessionStore::all() const {
  std::vector<SessionRow> sessions;
  Query rows(
      database_,
      // One pass over the events: a subquery for each session would take the square of their number.
      "SELECT id, examinee, number, run_mode, started_utc, software_version, machine, device, pseudo_haptic, "
      "channel, seed, observer, force_scale, ended, coalesce(resumed, 0) FROM session LEFT JOIN (SELECT "
      "session, max(utc) FILTER (WHERE kind = 'session ended') AS ended, count(*) FILTER (WHERE kind = "
      "'resumed') AS resumed FROM event GROUP BY session) AS happened ON happened.session = session.id ORDER "
      "BY id");
  while (rows.next()) {
    SessionRow session{.id = rows.integer(0), .number = rows.number(2)};
    session.facts = {.examinee = rows.text(1),
                     .run_mode = run_mode_from(rows.text(3)),
                     .software_version = rows.text(5),
                     .machine = rows.text(6),
                     .device = rows.text(7),
                     .pseudo_haptic = rows.number(8) != 0,
                     .channel = rows.text(9),
                     .force_scale = rows.real(12),
                     .seed = {},
                     .observer = rows.optional_text(11)};
    if (const auto seed = rows.optional_text(10)) session.facts.seed = seed_from(*seed);
    session.started_utc = rows.text(4);
    session.ended_utc = rows.optional_text(13);
    session.times_resumed = rows.number(14);
    sessions.push_back(std::move(session));
  }
  return sessions;
}

}  // namespace palpate::trials
