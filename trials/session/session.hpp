#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "trials/protocol/protocol.hpp"
#include "trials/study/study_file.hpp"
#include "trials/trace/trace.hpp"

namespace palpate::trials {

/// Seconds of pause between the intervals of a trial; the page keeps it.
constexpr double kPauseBetweenIntervals = 1.0;

/// Ready -> Interval -> Pause -> Interval -> Question -> Ready -> ... -> Finished. An interval that was not
/// explored enough goes back: Interval -> Pause -> the same interval.
enum class Phase { Ready, Interval, Pause, Question, Finished };
std::string_view to_string(Phase phase);

/// What a page may know: nothing here depends on condition, model or correct answer.
struct SessionView {
  Phase phase = Phase::Ready;
  int interval = 0;   // that runs, or that comes next: 1, 2 (0 while the question is open or all is done)
  int intervals = 2;  // of a trial
  int number = 0;     // of the question, from 1; 0 when all is done
  int questions = 0;  // of the sitting; where answers decide, at most
  std::string question{};
  std::span<const Choice> choices{};       // what can be answered: answer k is choices[k - 1]
  std::string_view hint{}, spoken_hint{};  // how to answer, to read and to hear
  bool resumed = false;
  RunMode run_mode = RunMode::Study;
  bool pseudo_haptic = false;
};

/// One examinee's sitting, driven by whoever presents it (the browser session, the simulated observers).
/// Every call that changes something is on the disk when it returns. Not thread-safe: keep it on one thread.
/// Calls out of turn throw std::logic_error.
class Session {
 public:
  ~Session();
  Session(Session&&) noexcept;
  Session& operator=(Session&&) noexcept;

  SessionView view() const;
  Phase phase() const;

  /// For the haptic loop only, never for the page: which of Protocol::stimuli the coming (or running)
  /// interval presents. Valid in Ready, Pause before an interval, and Interval.
  std::size_t stimulus() const;
  const Trial& trial() const;  // that is asked
  /// Trials that are drawn and unanswered, the one that is asked first. Answers may add to them.
  const std::vector<DrawnTrial>& pending() const;
  int answered() const;  // trials
  const SessionRow& row() const;

  /// Ready or Pause -> Interval. Stores that the interval was begun, so that a kill leaves the exposure
  /// known.
  void begin_interval();
  /// Interval -> Pause (next interval, or the same again) or Question. Stores record and trace.
  Verdict end_interval(const IntervalRecord& record);
  /// The interval was cut off (page closed, device lost): what was felt is stored, and the trial starts anew
  /// with its order drawn again. Interval, Pause or Question -> Ready.
  void interrupt(const IntervalRecord& felt_so_far, std::string_view reason);
  /// Question -> Ready or Finished. `response` is the number of a choice, from 1. Where the
  /// procedure chooses the next trial by it, that is drawn and stored with the answer, before it is shown.
  /// @param response_time  from the question's onset, monotonic clock [s]; none for a simulated observer
  void answer(int response, std::optional<double> response_time, std::string_view onset_utc);

  /// Early keys, strategy text, checklist: anything that is not an answer.
  void note(std::string_view kind, std::string_view text);

  /// The receipt of the study's hash chain as it stands.
  Receipt receipt() const;

  struct State;

 private:
  friend Session start_session(StudyFile&, const Protocol&, const SessionFacts&, bool);
  explicit Session(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

/// Refuses what start_session() would refuse, and writes nothing; also runs check_study(), and
/// require_whole() where there is a file. Throws std::invalid_argument: a code that is no code (1 to 32
/// letters, digits, hyphens), one near to another examinee's (P1 against P01 or p01), a finished examinee
/// without `new_session`, an unfinished sitting of another seed or observer.
void check_start(const std::filesystem::path& path, const Protocol& protocol, const SessionFacts& facts,
                 bool new_session);

/// Refuses a code that a person and a simulated examinee would share: `session` is of `examinee`, and one of
/// both, but not the other, is simulated.
void check_not_shared(const SessionRow& session, std::string_view examinee, RunMode run_mode);

/// Resumes the examinee's unfinished sitting of this run mode at its first unanswered trial (whose order is
/// drawn again when any of it had been felt; the procedure hears of the stored answers anew), or begins a new
/// one. `study` and `protocol` must outlive the
/// session. Until `study` is closed no other program leads a session in it: std::runtime_error when one does.
Session start_session(StudyFile& study, const Protocol& protocol, const SessionFacts& facts,
                      bool new_session = false);

}  // namespace palpate::trials
