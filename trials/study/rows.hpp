#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "trials/plan/plan.hpp"
#include "trials/protocol/protocol.hpp"
#include "trials/study/run_mode.hpp"
#include "trials/trace/trace.hpp"

namespace palpate::trials {

/// What is stored with every sitting about how it was run.
struct SessionFacts {
  std::string examinee{};  // a code, never a name
  RunMode run_mode = RunMode::Study;
  std::string software_version{};
  std::string machine{};
  std::string device{};                   // "mouse", "simulated observer"
  bool pseudo_haptic = false;             // no force reaches the hand
  std::string channel{};                  // what carries the stimulus then: "pointer lag"; else empty
  double force_scale = 1.0;               // of the force that reaches the hand
  Seed seed{};                            // of the order; none: the operating system's entropy
  std::optional<std::string> observer{};  // parameters of a simulated examinee, as JSON
};

/// The study that a file holds: its identity and the design as it was run.
struct StudyRow {
  std::string uuid{};
  std::string created_utc{};
  std::string protocol_name{}, protocol_text{}, protocol_sha256{};
  std::string scene_text{};
  std::vector<FileHash> files{};
  std::string software_version{};
};

struct SessionRow {
  std::int64_t id = 0;
  int number = 0;  // of this examinee's sittings, from 1
  SessionFacts facts{};
  std::string started_utc{};
  std::optional<std::string> ended_utc{};  // empty: unfinished
  int times_resumed = 0;
};

/// A trial as drawn. `draw` is 0, or counts how often an interruption made it be drawn again.
struct DrawnTrial {
  std::int64_t session = 0;
  int draw = 0;
  Trial trial{};
};

/// One presentation of one interval, re-exposures included.
struct PresentationRow {
  std::int64_t id = 0, session = 0;
  int trial = 0, draw = 0, interval = 0;
  int attempt = 0;            // from 1: counts presentations of this interval of this draw
  std::size_t condition = 0;  // into Protocol::conditions
  std::string begun_utc{};
  std::string onset_utc{};
  std::optional<Verdict> verdict{};  // none: never closed, the program died meanwhile; nothing was measured
  ExplorationSummary exploration{};
  double clamped_fraction = 0.0;
  std::optional<LoopTiming> loop{};
  std::optional<SolveRecord> solve{};  // none either of a loop that an older palpate recorded
  std::size_t samples = 0;             // of its trace; load_trace() reads it
  std::string trace_sha256{};

  bool closed() const { return verdict.has_value(); }
};

struct AnswerRow {
  std::int64_t entry = 0;  // in the hash chain
  std::int64_t session = 0;
  int trial = 0, draw = 0;
  int response = 0;  // interval, from 1
  bool correct = false;
  std::optional<double> response_time{};  // from the question's onset [s]; a simulated observer has none
  std::string onset_utc{};                // of the question
  std::string committed_utc{};
};

}  // namespace palpate::trials
