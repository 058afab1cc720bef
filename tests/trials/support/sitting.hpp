#pragma once

#include "trials/session/session.hpp"

namespace palpate::trials::test {

inline SessionFacts facts_of(std::string examinee, RunMode mode = RunMode::Study, Seed seed = 1) {
  SessionFacts facts{.examinee = std::move(examinee), .run_mode = mode};
  facts.software_version = "0.1.0";
  facts.machine = "test";
  facts.device = "mouse";
  facts.pseudo_haptic = true;
  facts.channel = "pointer lag";
  facts.seed = seed;
  return facts;
}

/// One press to `depth` [m] and out again, pushed back by 100 N/m.
inline IntervalRecord press_to(double depth) {
  IntervalRecord record;
  record.onset_utc = "2003-12-03T09:30:00.000Z";
  for (int i = 0; i <= 100; ++i) {
    const double at = depth * (1.0 - std::abs(i - 50) / 50.0);
    record.trace.push_back({.time = static_cast<float>(i * 1e-3),
                            .proposed_depth = static_cast<float>(at),
                            .depth = static_cast<float>(at),
                            .displacement = {0, 0, static_cast<float>(at)},
                            .force = {0, 0, static_cast<float>(-100 * at)}});
  }
  return record;
}

inline constexpr double kDeepEnough = 4e-3;  // the protocol wants 3 mm

/// As a haptic loop that ran in real time records it.
inline IntervalRecord felt_in_a_loop() {
  IntervalRecord record = press_to(kDeepEnough);
  record.loop = LoopTiming{.rate_hz = 999.5, .p999_ms = 1.25, .missed_cycles = 2};
  record.solve = SolveRecord{.force_error_bound = 0.0125, .cycles_within_tolerance = 70, .cycles_at_cap = 3};
  return record;
}

/// Ready -> Question.
inline void feel_both(Session& session) {
  while (session.phase() != Phase::Question) {
    session.begin_interval();
    session.end_interval(press_to(kDeepEnough));
  }
}

inline void answer_all(Session& session) {
  while (session.phase() != Phase::Finished) {
    feel_both(session);
    session.answer(1, 0.8, "2003-12-03T09:30:05.000Z");
  }
}

}  // namespace palpate::trials::test
