#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "analysis/detection/dprime.hpp"
#include "analysis/report/contrasts.hpp"
#include "analysis/report/primary_test.hpp"
#include "analysis/report/study_table.hpp"
#include "analysis/resampling/sign_flip.hpp"
#include "analysis/statistics/bayes/bayes_factor.hpp"
#include "analysis/statistics/beta_binomial/beta_binomial.hpp"
#include "analysis/statistics/examinee_level/examinee_level.hpp"
#include "analysis/statistics/interval_bias/interval_bias.hpp"
#include "analysis/statistics/similarity/similarity.hpp"
#include "analysis/statistics/wilcoxon/signed_rank.hpp"

namespace palpate::analysis {

struct ReportOptions {
  std::optional<std::string>
      run_mode{};                  // which of the study's run modes; may be empty when there is only one
  bool interim = false;            // results before the planned sample is complete
  double level = 0.95;             // confidence of all intervals
  std::string software_version{};  // of the program that writes the report
  std::string written_utc{};       // when
  std::string receipt{};           // of the study file as it was read: what the numbers can be held against
};

/// From the question's onset to the answer [s].
struct ResponseTimes {
  std::size_t n = 0;
  double least = 0.0, lower_quartile = 0.0, median = 0.0, upper_quartile = 0.0, most = 0.0;
};

/// Everybody's answers under one cell, where the tests count only those of the first complete examinees.
struct AllAnswers {
  long correct = 0, trials = 0;
  std::vector<ExamineeCount> by_examinee{};  // in the order of StudyReport::examinees
};

/// What the answers of a cell say where the planned test does not reject: how large a difference remains
/// possible, and how much they speak for chance.
struct EvidenceForChance {
  std::optional<SimilarityTest> similarity{};  // empty where the test looks below chance only
  BayesFactor bayes{};
};

/// Each examinee's first half of answers under one cell beside the last half (a middle one is in neither).
struct Learning {
  long correct_first = 0, trials_first = 0, correct_last = 0, trials_last = 0;
  double mean_difference = 0.0;  // of the examinees' proportions correct, last less first
  SignFlipTest sign_flip{};
};

/// What was asked and answered under one cell. What cannot be computed (no answers) or must not be shown yet
/// (the planned sample is not complete) is empty.
struct CellResult {
  std::string name{};
  long correct = 0, trials = 0, voided = 0;      // answers that the tests count, see StudyReport::sample
  std::vector<ExamineeCount> by_examinee{};      // in the order of StudyReport::examinees; trials may be 0
  std::optional<AllAnswers> all{};               // where there are answers that are not counted
  std::optional<PrimaryTest> primary{};          // on all counted answers together
  std::optional<double> p_adjusted{};            // of the primary test, where the protocol adjusts
  std::optional<EvidenceForChance> evidence{};   // where the primary test does not reject
  std::optional<Interval> over_examinees{};      // for the proportion correct: examinees drawn anew
  std::optional<ExamineeLevelTest> by_people{};  // of complete examinees
  std::optional<BetaBinomial> spread{};          // of examinees' proportions; empty where answers cannot tell
  std::optional<DPrime> d_prime{};
  std::optional<IntervalBias> bias{};
  std::optional<ResponseTimes> response_times{};  // where they were recorded
  std::optional<Learning> learning{};             // where an examinee has two answers or more
};

/// Cells compared on differences within examinees: proportion correct under the contrast's `first` less that
/// under its `second`.
struct CellComparison {
  Contrast contrast{};
  std::size_t examinees = 0;  // complete ones with answers counted under both
  double mean_difference = 0.0;
  std::optional<SignFlipTest> sign_flip{};
  std::optional<SignedRankTest> signed_rank{};
  std::string planned{};  // "sign-flip", "wilcoxon": what the protocol names; "none"
  std::optional<double>
      p_adjusted{};  // of the planned test, where there are several and the protocol adjusts
};

/// How a stimulus was explored and presented, over all intervals of one condition of one cell.
struct StimulusSummary {
  std::string cell{}, condition{};
  long intervals = 0;
  long shown_again = 0;  // presentations that led to no answer: not explored enough, or cut off
  double mean_presses = 0.0;
  std::optional<double> mean_exploration_s{}, mean_peak_force_n{}, mean_max_depth_m{};
  std::optional<double> worst_clamped_fraction{}, worst_loop_p999_ms{};
  std::optional<double> worst_force_error_bound_n{};
  std::optional<long> missed_cycles{}, cycles_within_tolerance{}, cycles_at_cap{};
};

struct VoidedTrial {
  std::string examinee{}, cell{}, reason{};
  int session = 0;  // number of the examinee's sitting
  int trial = 0;
};

/// Everything that a report says, in the order in which it says it. The writers (html, text, json) only lay
/// it out.
struct StudyReport {
  StudyDesign design{};
  ReportOptions options{};
  std::string run_mode{};
  bool pseudo_haptic = false;
  std::string channel{};
  std::vector<std::string> banners{};  // what must stand on every page; empty for a study with a device
  std::vector<std::string> summary{};  // in plain words, a paragraph each
  long planned_examinees = 0, complete_examinees = 0;
  bool complete = false;            // the planned sample was reached
  std::optional<long> sample{};     // the tests count so many examinees, the first to complete; empty: the
                                    // sample is not complete, and all answers so far are counted
  std::optional<LookTaken> look{};  // where the protocol plans looks and one is due
  bool withheld = false;            // incomplete, no look due and none asked for: no test is in the report
  std::vector<std::string> examinees{};
  std::vector<bool> is_complete{};  // one for each of them
  std::vector<CellResult> cells{};
  std::vector<CellComparison> comparisons{};
  std::vector<StimulusSummary> stimuli{};
  std::vector<ForceCurve> curves{};  // of this run mode
  std::vector<VoidedTrial> voided{};
  std::vector<ReportedSession> sessions{};  // of this run mode
  std::vector<std::string> parts{};         // as StudyTable has them
  std::vector<FrozenPlan> frozen_plans{};
  std::vector<LookEvent> interim_looks{};  // at results of this run mode, that were not planned
  std::vector<LookEvent> planned_looks{};  // when each was first taken; this one as well
  std::vector<std::string> plan{};         // what was fixed beforehand, a sentence each
  std::vector<std::string> deviations{};   // from it, likewise
  std::string pooled_claim{}, people_claim{}, comparison_claim{};
  std::vector<std::string> method{};  // the method section, a paragraph each
  std::vector<std::string> limits{};
};

/// Computes the report of one run mode of a study. Linear in the number of trials.
/// Throws std::invalid_argument for what cannot be answered honestly: no session of the run mode, several run
/// modes and none named, sessions of another protocol, haptic and pseudo-haptic sessions mixed, a task or a
/// test that this version does not know, an order of intervals that is not a fair coin, rows that contradict
/// themselves.
StudyReport analyse(const StudyTable& table, const ReportOptions& options = {});

}  // namespace palpate::analysis
