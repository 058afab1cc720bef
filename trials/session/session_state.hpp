#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "trials/session/session.hpp"
#include "trials/study/stores.hpp"

namespace palpate::trials {

/// What a Session knows while it runs; all of it can be read back from the study file after a kill. The
/// functions that write expect a transaction of the caller's.
struct Session::State {
  StudyFile& study;
  StudyFile::Stores& stores;
  const Protocol& protocol;
  SessionRow row{};
  std::vector<DrawnTrial> pending{};  // unanswered trials as last drawn, the next one first
  ProcedureState procedure{};         // after the answers that are stored
  Phase phase = Phase::Ready;
  int interval = 1;               // that runs or comes next
  int attempt = 0;                // of that interval: presentations begun
  std::int64_t presentation = 0;  // that runs
  bool resumed = false;

  /// Throws std::logic_error unless `phase` is one of those accepted.
  void expect(std::initializer_list<Phase> accepted, std::string_view call) const;
  std::size_t condition() const;  // of the interval that runs or comes next

  void store_end(const IntervalRecord& record, Verdict verdict);
  /// What is asked after the answers that `told` knows of. A trial that was not drawn ahead is drawn, stored
  /// with its event, and returned; where nothing is left to ask, the sitting's end is stored.
  std::optional<DrawnTrial> draw_next(const ProcedureState& told);
  DrawnTrial draw_again();  // stores the next draw of the current trial, with its event, and returns it
  void append_event(std::string_view kind, std::string_view text);
  void start_trial();  // the first interval comes next; writes nothing

  void begin(const SessionFacts& facts, const std::vector<SessionRow>& earlier);
  void resume(const SessionRow& unfinished, const SessionFacts& now);
};

}  // namespace palpate::trials
