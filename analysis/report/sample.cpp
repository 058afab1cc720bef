#include "analysis/report/sample.hpp"

#include <algorithm>
#include <functional>
#include <map>

namespace palpate::analysis {
namespace {

bool earlier(const TrialRow* a, const TrialRow* b) {
  if (a->answered_utc != b->answered_utc) return a->answered_utc < b->answered_utc;  // ISO 8601 sorts by time
  return std::less<>()(a, b);                                                        // rows of one table
}

}  // namespace

std::vector<Completion> completions(const StudyDesign& design, const Selection& selection) {
  std::vector<const TrialRow*> asked = selection.trials;
  asked.insert(asked.end(), selection.voided.begin(), selection.voided.end());
  std::ranges::sort(asked, earlier);
  const std::size_t needed = std::max(1, design.trials_per_examinee_per_cell);
  std::vector<std::vector<std::size_t>> counts(selection.examinees.size(),
                                               std::vector<std::size_t>(design.cells.size(), 0));
  std::vector<std::size_t> cells_done(selection.examinees.size(), 0);
  std::vector<Completion> complete;
  for (const TrialRow* trial : asked) {
    const std::size_t examinee = selection.examinee_of[trial->session];
    if (++counts[examinee][trial->cell] != needed) continue;
    if (++cells_done[examinee] == design.cells.size())
      complete.push_back({.examinee = examinee, .last = trial});
  }
  return complete;
}

std::vector<const TrialRow*> answers_of_first(std::size_t count, const std::vector<Completion>& complete,
                                              const StudyDesign& design, const Selection& selection) {
  std::map<std::size_t, const TrialRow*> last;  // of each examinee who counts
  for (std::size_t i = 0; i < std::min(count, complete.size()); ++i)
    last[complete[i].examinee] = complete[i].last;
  const bool fixed = design.trials_per_examinee_per_cell > 0;  // else no answer is one too many
  std::vector<const TrialRow*> counted;
  for (const TrialRow* trial : selection.trials) {
    const auto found = last.find(selection.examinee_of[trial->session]);
    if (found == last.end() || (fixed && earlier(found->second, trial))) continue;
    counted.push_back(trial);
  }
  return counted;
}

}  // namespace palpate::analysis
