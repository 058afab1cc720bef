#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/clock/utc.hpp"
#include "trials/protocol/protocol.hpp"

namespace palpate::trials {

/// One cycle of an interval, as really driven. Single precision, as it is stored.
struct TraceSample {
  float time = 0;            // since the interval's onset [s]
  float proposed_depth = 0;  // where hand or pointer asked the finger to be, along its direction [m]
  float depth = 0;           // where the finger was driven, along its direction; > 0 in the body [m]
  std::array<float, 3> displacement{};  // of the probe as driven [m]
  std::array<float, 3> force{};         // delivered to the finger, after any clamp [N]

  bool operator==(const TraceSample&) const = default;
};
using Trace = std::vector<TraceSample>;

/// How the haptic loop kept time; empty where no loop ran in real time.
struct LoopTiming {
  double rate_hz = 0.0;
  double p999_ms = 0.0;  // 99.9 % of cycles began no later than this after the one before
  long missed_cycles = 0;
};

/// How exactly the forces of a presentation were computed: of the cycles that the haptic loop ran for it.
struct SolveRecord {
  double force_error_bound = 0.0;    // the largest of a cycle [N]; see sim::SolveReport
  long cycles_within_tolerance = 0;  // in which the law stopped early, as contact.tolerance lets it
  long cycles_at_cap = 0;            // in which it stopped at its cap on iterations
};

/// One presentation of an interval, from its onset until it was closed.
struct IntervalRecord {
  std::string onset_utc{};  // ISO 8601, see base::utc_now()
  Trace trace{};
  double clamped_fraction = 0.0;  // share of cycles in which the device's limit cut the force, 0..1
  std::optional<LoopTiming> loop{};
  std::optional<SolveRecord> solve{};  // with the loop's timing
};

/// What a trace says about how the body was explored.
struct ExplorationSummary {
  int presses = 0;          // times that the hand went in and out again, or was still in at the end
  double time = 0.0;        // from onset to the last sample [s]
  double peak_force = 0.0;  // largest |force| [N]
  double max_depth = 0.0;   // deepest sample in contact: depth > 0 and the finger felt a force [m]
  double hand_depth = 0.0;  // deepest place of the hand [m]
};
/// Presses and depth are judged by the hand, which is the finger's place where a device pushes back. Where none
/// does, stiffer tissue leaves the finger further behind, and judging by the finger would tell which it is.
ExplorationSummary summarise(const Trace& trace);

/// Counts presses while an interval runs, with the same rule as summarise(): one begins when the depth
/// exceeds 0.5 mm and ends when it is back below 0.25 mm, so that trembling on the skin is no press.
class PressCounter {
 public:
  void add(double depth);  // [m], sample by sample
  int begun() const { return begun_; }
  bool pressing() const { return pressing_; }

 private:
  int begun_ = 0;
  bool pressing_ = false;
};

/// How a presentation ended: fulfilling the exploration rule, or else why it is shown again. `Interrupted`:
/// cut off, whatever had been felt by then.
enum class Verdict { Enough, TooFewPresses, TooManyPresses, TooShallow, Interrupted };

/// Never `Interrupted`.
Verdict judge(const ExplorationSummary& summary, const Exploration& rule);

/// What the examinee (or the log) is told: never anything about the stimulus.
std::string_view to_string(Verdict verdict);
/// The verdict that the log has this word for. Throws std::invalid_argument, lists what is accepted.
Verdict verdict_from(std::string_view word);

/// A trace as the study file keeps it: little-endian float32 column by column, zlib.
std::string encode(const Trace& trace);
/// Throws std::invalid_argument for bytes that encode() did not make or another number of samples.
Trace decode(std::string_view bytes, std::size_t samples);

}  // namespace palpate::trials
