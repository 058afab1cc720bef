#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "trials/study/event.hpp"
#include "trials/study/rows.hpp"
#include "trials/study/study_file.hpp"

namespace palpate::trials {

/// An answer with the question that it was given to, what was felt for it, and whether it counts.
struct AnsweredTrial {
  std::shared_ptr<const SessionRow> session{};  // one for all answers of a sitting
  DrawnTrial drawn{};                           // as it was answered
  AnswerRow answer{};
  /// What the answer was given to: of each interval of this draw the presentation that was explored enough
  /// (the last one, should a file hold several), in the order of the intervals.
  std::vector<PresentationRow> intervals{};
  /// What else was felt of this trial: repeated intervals and other draws, in the order of time.
  std::vector<PresentationRow> exposures{};
  std::optional<std::string> void_reason{};  // the last one given; none: the answer counts
};

/// A presentation that no answer was given to.
struct Exposure {
  std::shared_ptr<const SessionRow> session{};
  PresentationRow presentation{};
};

/// Every answer of a study, by sitting, then trial. Reads every table once. Throws std::invalid_argument for
/// a damaged file in which an answer has no trial.
std::vector<AnsweredTrial> answered_trials(const StudyFile& study);

/// Everything that was felt without being answered, of answered trials and of others, by sitting, then in the
/// order of time. Reads and throws as answered_trials() does.
std::vector<Exposure> exposures(const StudyFile& study);

/// What the file holds of one sitting: trials by number and draw, presentations in the order of time.
struct SittingRows {
  std::vector<DrawnTrial> trials{};
  std::vector<PresentationRow> presentations{};
  std::vector<AnswerRow> answers{};
};

/// The same, joined; every presentation is in it once.
struct JoinedSitting {
  std::vector<AnsweredTrial> answered{};
  std::vector<PresentationRow> unanswered{};  // of trials without an answer, in the order of time
  std::vector<AnswerRow> without_trial{};     // given to a draw that is not there: the file is damaged
};

/// Why trials were voided, by session and trial; the last reason counts.
using VoidReasons = std::map<std::pair<std::int64_t, int>, std::string>;
VoidReasons void_reasons(const std::vector<EventRow>& events);

/// The join that everything above is made of. Never throws for what a damaged file may hold.
JoinedSitting join(const SessionRow& session, SittingRows rows, const VoidReasons& reasons);

/// All that was shown of the draw that was answered, repeated intervals included, in the order of time: what
/// the answer's entry of the chain is hashed over.
std::vector<PresentationRow> shown_for(const AnsweredTrial& trial);

/// The presentations of one draw of one trial, be it answered or not.
std::vector<PresentationRow> presentations_of(const std::vector<PresentationRow>& all,
                                              const DrawnTrial& drawn);

}  // namespace palpate::trials
