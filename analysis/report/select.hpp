#pragma once

#include <vector>

#include "analysis/report/report.hpp"

namespace palpate::analysis {

/// What enters a report: indices into StudyTable::sessions of one run mode, and the counted trials of theirs.
struct Selection {
  std::string run_mode{};
  std::vector<bool> sessions{};           // one for each of StudyTable::sessions
  std::vector<const TrialRow*> trials{};  // answered, not voided
  std::vector<const TrialRow*> voided{};
  std::vector<std::string> examinees{};    // of these sessions, in the order of their first one
  std::vector<std::size_t> examinee_of{};  // index into examinees, one for each of StudyTable::sessions
};

/// Refuses a design that this version cannot analyse, and rows that contradict it.
void validate(const StudyTable& table);

/// Picks the sessions of one run mode; practice is never reported. Throws std::invalid_argument that names
/// the run modes found where none is named and there are several, and for sessions that must not be pooled.
Selection select(const StudyTable& table, const ReportOptions& options);

}  // namespace palpate::analysis
