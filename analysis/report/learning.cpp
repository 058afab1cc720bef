#include "analysis/report/learning.hpp"

#include <algorithm>
#include <map>
#include <tuple>

namespace palpate::analysis {
namespace {

/// One examinee's answers under one cell, in the order of trials.
using Answers = std::vector<const TrialRow*>;

ExamineeCount count(Answers::const_iterator from, Answers::const_iterator to) {
  ExamineeCount counts;
  for (; from != to; ++from) {
    ++counts.trials;
    counts.correct += *(*from)->correct ? 1 : 0;
  }
  return counts;
}

std::optional<Learning> learning_of(const std::map<std::size_t, Answers>& by_examinee, double level) {
  Learning learning;
  std::vector<double> differences;
  for (const auto& [examinee, answers] : by_examinee) {
    const auto half = static_cast<std::ptrdiff_t>(answers.size() / 2);
    if (half == 0) continue;
    const ExamineeCount first = count(answers.begin(), answers.begin() + half);
    const ExamineeCount last = count(answers.end() - half, answers.end());
    learning.correct_first += first.correct, learning.trials_first += first.trials;
    learning.correct_last += last.correct, learning.trials_last += last.trials;
    differences.push_back(static_cast<double>(last.correct - first.correct) / static_cast<double>(half));
  }
  if (differences.empty()) return std::nullopt;
  learning.sign_flip = sign_flip_test(differences, {.level = level});
  learning.mean_difference = learning.sign_flip.mean;
  return learning;
}

}  // namespace

std::vector<std::optional<Learning>> learning(const Selection& selection,
                                              const std::vector<const TrialRow*>& trials, std::size_t cells,
                                              double level) {
  std::vector<std::map<std::size_t, Answers>> answers(cells);
  for (const TrialRow* trial : trials)
    answers[trial->cell][selection.examinee_of[trial->session]].push_back(trial);
  std::vector<std::optional<Learning>> all;
  for (auto& cell : answers) {
    for (auto& [examinee, given] : cell)
      std::ranges::stable_sort(
          given, {}, [](const TrialRow* trial) { return std::tuple(trial->session, trial->trial); });
    all.push_back(learning_of(cell, level));
  }
  return all;
}

}  // namespace palpate::analysis
