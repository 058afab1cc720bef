#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "trials/study/answered_trials.hpp"
#include "trials/tables/codebook.hpp"

namespace palpate::trials {

using Value = std::variant<std::monostate, std::int64_t, double, std::string>;  // monostate: missing

/// A table for other tools: one row an observation, every row as long as `columns`.
struct Table {
  std::string name;
  std::vector<Column> columns{};
  std::vector<std::vector<Value>> rows{};
};

// The tables of a study of `design`; its file is read once for all of them.

/// One row an answered question.
Table trial_table(const Protocol& design, const std::vector<AnsweredTrial>& answered);

/// One row an interval of an answered question, as it counted.
Table interval_table(const Protocol& design, const std::vector<AnsweredTrial>& answered);

/// One row a presentation that did not count: explored too little, or of a trial that was cut off.
Table exposure_table(const Protocol& design, const std::vector<Exposure>& exposures);

/// One row an event of a sitting that no other table tells of: what the examinee wrote at the end, early keys,
/// interruptions. Without what is there for the chain alone (begun, drawn), the end, and voided trials.
Table event_table(const std::vector<SessionRow>& sessions, const std::vector<EventRow>& events);

}  // namespace palpate::trials
