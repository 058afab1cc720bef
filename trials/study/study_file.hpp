#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "trials/plan/plan.hpp"
#include "trials/protocol/protocol.hpp"
#include "trials/trace/trace.hpp"

namespace palpate::trials {

enum class RunMode { Study, Pilot, Practice, Simulated };
std::string_view to_string(RunMode mode);
RunMode run_mode_from(std::string_view name);  // throws std::invalid_argument, lists what is accepted

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
  int attempt = 0;  // from 1: counts presentations of this interval of this draw
  std::string condition{};
  std::string begun_utc{};
  std::string onset_utc{};
  std::string verdict{};  // "enough", or why it was shown again
  bool complete = true;   // false: cut short by an interruption
  ExplorationSummary exploration{};
  double clamped_fraction = 0.0;
  std::optional<LoopTiming> loop{};
  std::size_t samples = 0;  // of its trace; load_trace() reads it
  std::string trace_sha256{};
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

/// Kinds of events that mean something to this program; others are kept as they are.
namespace event_kind {
constexpr std::string_view kVoided = "voided";           // the trial does not count; the text is the reason
constexpr std::string_view kBegun = "session begun";     // the text: the sitting's facts, hash of its plan
constexpr std::string_view kDrawnAgain = "drawn again";  // the text: the trial, hash of what was felt before
constexpr std::string_view kDrawn = "drawn";  // a trial that depended on answers; the text: the trial
constexpr std::string_view kInterrupted = "interrupted";
constexpr std::string_view kResumed = "resumed";
constexpr std::string_view kEnded = "session ended";
constexpr std::string_view kEarlyKey = "early key";
constexpr std::string_view kStrategy = "strategy";
constexpr std::string_view kMerged = "merged";  // the file was joined from others; the text tells of which
}  // namespace event_kind

/// Things that happened apart from answers. Append-only, chained with the answers.
struct EventRow {
  std::int64_t entry = 0;  // in the hash chain; set by the file
  std::optional<std::int64_t> session{};
  std::optional<int> trial{};
  std::string kind{};  // see event_kind
  std::string text{};
  std::string utc{};
};

/// Where the hash chain stands: printed as a receipt at a session's end, "120-9f86d0...".
struct Receipt {
  std::int64_t entries = 0;
  std::string head{};  // 64 hexadecimal digits; the first 16 or more, in one read from paper

  bool operator==(const Receipt&) const = default;
};
std::string to_string(const Receipt& receipt);
/// Reads one that was printed or written down by hand: 16 or more of the head's digits, in any case, with
/// spaces around. Throws std::invalid_argument.
Receipt parse_receipt(std::string_view text);

/// An open study file: one SQLite database. All SQL is in the stores behind it.
/// Every function throws std::runtime_error that names the file when the disk refuses; what was committed
/// stays.
class StudyFile {
 public:
  ~StudyFile();
  StudyFile(StudyFile&&) noexcept;
  StudyFile& operator=(StudyFile&&) noexcept;

  const std::filesystem::path& path() const;
  StudyRow study() const;
  const Protocol& protocol() const;          // the design that the file holds; scene and meshes not looked at
  std::vector<SessionRow> sessions() const;  // in the order in which they began
  std::vector<DrawnTrial> trials(std::int64_t session) const;              // by number, then draw
  std::vector<PresentationRow> presentations(std::int64_t session) const;  // in the order of time
  std::vector<AnswerRow> answers(std::int64_t session) const;              // by trial
  std::vector<EventRow> events() const;
  Trace load_trace(std::int64_t presentation) const;  // throws std::invalid_argument when it is damaged
  Receipt receipt() const;

  /// Voids a trial (or answers to it later), with the reason; the answer stays.
  void add_event(const EventRow& event);

  /// Keeps other programs from leading a session in this study until this file is closed, or the process
  /// dies. Throws std::runtime_error when one does already, with its process id where the system tells it.
  void lock_for_sessions();

  struct Stores;
  Stores& stores() { return *stores_; }  // for Session only

 private:
  friend StudyFile open_study(const std::filesystem::path&, const Protocol&, std::string_view);
  friend StudyFile read_study(const std::filesystem::path&);
  explicit StudyFile(std::unique_ptr<Stores> stores);
  std::unique_ptr<Stores> stores_;
};

/// Refuses what open_study() would refuse, and writes nothing: a file that is no study file (foreign,
/// truncated, empty, of a newer version), a study of another protocol, scene or mesh, a folder that is
/// missing or cannot be written, a network drive. A file that does not exist is fine.
void check_study(const std::filesystem::path& path, const Protocol& protocol);

/// Opens the study of `protocol`, or makes it (whole or not at all) where there is no file yet. Checks first,
/// as check_study() does. Call it when nothing else can fail any more.
StudyFile open_study(const std::filesystem::path& path, const Protocol& protocol,
                     std::string_view software_version);

/// Opens an existing study file for reading only. Throws std::invalid_argument for a file that is none.
StudyFile read_study(const std::filesystem::path& path);

/// A study file that another one was joined from, as it was then.
struct MergedPart {
  std::string site{};  // put before its examinees' codes, "Osaka-P01"; empty: they stayed as they were
  std::string file{};  // its name, without folders
  std::string uuid{}, created_utc{}, software_version{};
  std::int64_t sessions = 0;
  Receipt receipt{};

  bool operator==(const MergedPart&) const = default;
};

/// The parts of a joined study file, in order; none where it was not joined. Throws std::invalid_argument
/// when what is written of them cannot be read.
std::vector<MergedPart> merged_parts(const std::vector<EventRow>& events);

/// What `palpate verify` found.
struct VerifyReport {
  std::vector<std::string> problems{};  // empty: the file is whole
  Receipt receipt{};
  int sessions = 0, answers = 0, presentations = 0, voided = 0;
  std::vector<MergedPart> parts{};  // of a joined file
};

/// What verify_study() looks at. `Answers`: all but the database's pages and the traces' contents, which take
/// time in a large file.
enum class VerifyScope { Answers, Everything };

/// Integrity of the database, its schema, every hash, the chain, answers against the plan, every trace. With
/// a receipt, whether the chain still holds the entry that the receipt was printed for; in a joined file, the
/// receipts of its parts hold as well. A table that is missing or a protocol that cannot be read is a problem
/// in the report; throws std::invalid_argument for what is no study file, or too damaged to be read as one.
VerifyReport verify_study(const std::filesystem::path& path, const std::optional<Receipt>& receipt = {},
                          VerifyScope scope = VerifyScope::Everything);

/// Throws std::invalid_argument, with the number of problems and the first of them, unless answers, orders
/// and chain fit together (VerifyScope::Answers).
void require_whole(const std::filesystem::path& study);

}  // namespace palpate::trials
