#include "analysis/report/sample.hpp"

#include <algorithm>
#include <map>
#include <string>
#include <tuple>

namespace palpate::analysis {
namespace {

// Where each answer stands among all: within a chain in its order, between chains by the clock. There an
// answer counts as given no earlier than those before it in its chain, so that both orders agree.
std::map<const TrialRow*, std::size_t> places(const Selection& selection) {
  struct Told {
    std::string utc{};
    const TrialRow* trial = nullptr;
  };
  std::vector<Told> told;
  for (const auto* trials : {&selection.trials, &selection.voided})
    for (const TrialRow* trial : *trials) told.push_back({trial->answered_utc, trial});
  const auto in_chain = [](const Told& one) {
    return std::tuple(one.trial->written.chain, one.trial->written.entry, one.trial);  // rows of one table
  };
  std::ranges::sort(told, {}, in_chain);
  for (std::size_t i = 1; i < told.size(); ++i) {
    const ChainPlace &before = told[i - 1].trial->written, &here = told[i].trial->written;
    if (before.chain == here.chain && before.entry > 0)
      told[i].utc = std::max(told[i].utc, told[i - 1].utc);  // ISO 8601 sorts by time
  }
  std::ranges::stable_sort(told, {}, &Told::utc);
  std::map<const TrialRow*, std::size_t> places;
  for (const Told& one : told) places.emplace(one.trial, places.size());
  return places;
}

}  // namespace

std::vector<Completion> completions(const StudyDesign& design, const Selection& selection) {
  std::vector<const TrialRow*> asked = selection.trials;
  asked.insert(asked.end(), selection.voided.begin(), selection.voided.end());
  const auto place_of = places(selection);
  std::ranges::sort(asked, {}, [&](const TrialRow* trial) { return place_of.at(trial); });
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
  const auto place_of = places(selection);
  const bool fixed = design.trials_per_examinee_per_cell > 0;  // else no answer is one too many
  std::vector<const TrialRow*> counted;
  for (const TrialRow* trial : selection.trials) {
    const auto found = last.find(selection.examinee_of[trial->session]);
    if (found == last.end() || (fixed && place_of.at(found->second) < place_of.at(trial))) continue;
    counted.push_back(trial);
  }
  return counted;
}

}  // namespace palpate::analysis
