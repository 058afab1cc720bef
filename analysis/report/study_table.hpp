#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace palpate::analysis {

// A study as plain tables: what the report reads, and all that it knows. The application fills it from a
// study file (see conventions of the trial log); analysis/ neither opens files nor knows what a protocol file
// is.

/// One combination of factor levels, e.g. {"kuroda"} for the factor "contact.model".
struct DesignCell {
  std::string name{};                 // as shown to a reader: "kuroda", or "kuroda, 0.3" with two factors
  std::vector<std::string> levels{};  // one for each entry of StudyDesign::factors
};

/// What the protocol fixed before the first answer.
struct StudyDesign {
  std::string protocol_name{};
  std::string protocol_sha256{};  // 64 hexadecimal digits
  std::string protocol_text{};    // the file as it was run, shown in the report's appendix; may be empty
  std::string question{};
  std::string task = "2IFC";
  double chance = 0.5;                    // share correct of an examinee who feels nothing
  std::vector<std::string> conditions{};  // those compared, in the protocol's order: "soft", "hard"
  std::string correct_condition{};        // the one whose interval is the correct answer
  std::vector<std::string> factors{};     // "contact.model"; empty: one cell
  std::vector<DesignCell> cells{};        // at least one; TrialRow::cell indexes into it
  int trials_per_examinee_per_cell = 0;   // 0: not fixed (an adaptive procedure)
  int planned_examinees = 0;
  std::string procedure = "constant";
  std::string cell_order = "shuffled";
  std::string interval_order = "coin";  // "coin": independent fair flips, which the exact binomial test needs
  int least_presses = 0, most_presses = 0;  // exploration rule; 0: none stated
  double min_depth_m = 0.0;
  double max_time_s = 0.0;
  std::string display_during_interval{};  // "hidden", "probe", "organs"
  double feedback_s = 0.0;                // for how long it is told if an answer was right; 0: never
  std::string primary = "paired-comparison";
  double alpha = 0.05;
  std::string side = "greater";         // "greater", "less", "two-sided"
  std::string adjust = "none";          // "holm", "hochberg", "benjamini-hochberg": p over the cells
  std::string between_models = "none";  // "sign-flip", "wilcoxon", "none"
  std::vector<int> looks{};             // complete examinees at each planned look; empty: at the end only
  std::string spending{};               // of alpha over the looks: "obrien-fleming", "pocock"
};

/// Where something stands in the chains of a study file, which tell in which order it was written, whatever
/// the clock said. A file that was joined from others has a chain for each.
struct ChainPlace {
  std::size_t chain = 0;
  std::int64_t entry = 0;  // from 1; 0: not recorded
};

/// Whether one thing came before another: by the chain where both stand in one, else by the clock.
bool came_before(const ChainPlace& a, const std::string& a_utc, const ChainPlace& b,
                 const std::string& b_utc);

/// One examinee's sitting.
struct ReportedSession {
  int session = 1;  // number of this examinee's sittings, from 1: the exports' session_id
  std::string examinee{};
  std::string run_mode{};  // "study", "pilot", "practice", "simulated"
  std::string protocol_sha256{};
  std::string software_version{};             // that began it
  std::vector<std::string> later_versions{};  // that took it up again, each once
  std::size_t part = 0;                       // into StudyTable::parts
  std::string device{};                       // "mouse", "simulated observer", ...
  std::string channel{};       // what carries the stimulus when pseudo_haptic: "pointer lag"; else empty
  std::string order_source{};  // "operating system" or "seed 42"
  std::string started_utc{};   // ISO 8601
  ChainPlace begun{};
  bool pseudo_haptic = false;
  bool finished = false;  // every scheduled trial answered or voided
  double force_scale = 1.0;
  int times_resumed = 0;
};

/// One presentation within a trial. What was not recorded stays empty.
struct IntervalRow {
  int interval = 1;  // 1-based
  std::string condition{};
  int n_presses = 0;
  std::optional<double> exploration_time_s{};
  std::optional<double> peak_force_n{};
  std::optional<double> max_depth_m{};
  /// Share of cycles in which the device's limit cut the force, 0..1.
  std::optional<double> clamped_fraction{};
  std::optional<double> loop_rate_hz{};
  std::optional<double> loop_p999_ms{};  // 99.9 % of cycles began no later than this after the one before
  std::optional<long> missed_cycles{};
  std::optional<double> force_error_bound_n{};                     // the largest of a cycle
  std::optional<long> cycles_within_tolerance{}, cycles_at_cap{};  // whose solution ended there
};

/// One question. A trial that was not answered yet is not in the table.
struct TrialRow {
  std::size_t session = 0;  // index into StudyTable::sessions
  std::size_t cell = 0;     // index into StudyDesign::cells
  int block = 1;
  int trial = 0;                  // 1-based number within the session
  std::string correct_answer{};   // "1" or "2": the interval of correct_condition; empty: there is no truth
  std::string response{};         // as answered: "1", "2"
  std::optional<bool> correct{};  // empty where there is no truth
  std::optional<double> response_time_s{};
  std::string answered_utc{};  // ISO 8601 with the same number of digits everywhere; empty: not recorded
  ChainPlace written{};
  bool voided = false;
  std::string void_reason{};
  std::vector<IntervalRow> intervals{};
  std::vector<std::string> shown_in_vain{};  // conditions of presentations that did not count: not explored
                                             // enough, or cut off
};

/// Force on the finger over its depth, the mean of all presses under one condition of one cell, resampled by
/// the application on a common depth axis. The three vectors have one length.
struct ForceCurve {
  std::size_t cell = 0;
  std::string condition{};
  std::string run_mode{};         // a curve goes only into the report of its own run mode
  std::vector<double> depth_m{};  // ascending
  std::vector<double> mean_force_n{};
  std::vector<double> deviation_n{};  // standard deviation between intervals; may be empty
  std::size_t intervals = 0;          // presses averaged
};

/// An analysis plan as it was frozen in the study file.
struct FrozenPlan {
  std::size_t part = 0;  // into StudyTable::parts
  std::string sha256{};  // of its text
  std::string frozen_utc{};
  ChainPlace written{};
  std::string software_version{};
};

/// That results were read while the study ran, as its file has logged it.
struct LookEvent {
  std::string run_mode{};  // of the results that were read; empty: it does not say
  int planned = 0;         // number of the look that the protocol plans; 0: nobody planned it
  std::string utc{};       // ISO 8601
  ChainPlace written{};
  std::string text{};  // what the file says of it
};

struct StudyTable {
  StudyDesign design{};
  std::vector<std::string> parts{};  // in words, what the file was joined from; none: it is one study's
  std::vector<FrozenPlan> frozen_plans{};
  std::vector<LookEvent> looks{};
  std::vector<ReportedSession> sessions{};
  std::vector<TrialRow> trials{};
  std::vector<ForceCurve> curves{};
  /// Withdrawn examinees and the like, one sentence each, told in the report.
  std::vector<std::string> notes{};
};

}  // namespace palpate::analysis
