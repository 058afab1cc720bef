#include <algorithm>
#include <map>
#include <stdexcept>

#include "analysis/numerics/result.hpp"
#include "analysis/report/evidence.hpp"
#include "analysis/report/learning.hpp"
#include "analysis/report/over_examinees.hpp"
#include "analysis/report/report.hpp"
#include "analysis/report/sample.hpp"
#include "analysis/report/select.hpp"
#include "analysis/report/sentences.hpp"
#include "analysis/report/stimuli.hpp"
#include "analysis/report/verdict.hpp"
#include "analysis/report/withhold.hpp"

namespace palpate::analysis {
namespace {

constexpr std::size_t kLargestSignedRank = 5000;

// Quantile of sorted values, linear between them (type 7 of Hyndman & Fan 1996, R's default).
double quantile(const std::vector<double>& sorted, double share) {
  const double place = share * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return sorted[below] + (place - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

std::optional<ResponseTimes> response_times(std::vector<double> seconds) {
  if (seconds.empty()) return std::nullopt;
  std::ranges::sort(seconds);
  return ResponseTimes{.n = seconds.size(),
                       .least = seconds.front(),
                       .lower_quartile = quantile(seconds, 0.25),
                       .median = quantile(seconds, 0.5),
                       .upper_quartile = quantile(seconds, 0.75),
                       .most = seconds.back()};
}

// Counts of one pass over the trials.
struct Counts {
  std::vector<OrderCounts> orders;                            // one for each cell
  std::vector<std::vector<double>> response_times;            // likewise
  std::vector<std::map<std::size_t, OrderStratum>> sittings;  // likewise, by session
};

Counts count(const Selection& selection, const std::vector<const TrialRow*>& trials,
             std::vector<CellResult>& cells) {
  Counts counts{.orders = std::vector<OrderCounts>(cells.size()),
                .response_times = std::vector<std::vector<double>>(cells.size()),
                .sittings = std::vector<std::map<std::size_t, OrderStratum>>(cells.size())};
  for (const TrialRow* trial : trials) {
    CellResult& cell = cells[trial->cell];
    ExamineeCount& examinee = cell.by_examinee[selection.examinee_of[trial->session]];
    OrderCounts& order = counts.orders[trial->cell];
    const bool first = trial->correct_answer == "1";
    const long correct = *trial->correct ? 1 : 0;
    ++cell.trials, ++examinee.trials, ++(first ? order.trials_first : order.trials_second);
    cell.correct += correct, examinee.correct += correct;
    (first ? order.correct_first : order.correct_second) += correct;
    OrderStratum& sitting = counts.sittings[trial->cell][trial->session];
    ++sitting.trials;
    sitting.correct += correct;
    sitting.correct_first += first ? 1 : 0;
    sitting.answers_first += trial->response == "1" ? 1 : 0;
    if (trial->response_time_s) counts.response_times[trial->cell].push_back(*trial->response_time_s);
  }
  for (const TrialRow* trial : selection.voided) ++cells[trial->cell].voided;
  return counts;
}

// Everybody's answers beside those that the tests count.
void count_all(const Selection& selection, StudyReport& report) {
  std::vector<AllAnswers> all(report.cells.size(),
                              AllAnswers{.by_examinee = std::vector<ExamineeCount>(report.examinees.size())});
  for (const TrialRow* trial : selection.trials) {
    AllAnswers& cell = all[trial->cell];
    ExamineeCount& examinee = cell.by_examinee[selection.examinee_of[trial->session]];
    const long correct = *trial->correct ? 1 : 0;
    ++cell.trials, ++examinee.trials;
    cell.correct += correct, examinee.correct += correct;
  }
  for (std::size_t c = 0; c < all.size(); ++c)
    if (all[c].trials > report.cells[c].trials) report.cells[c].all = std::move(all[c]);
}

// How unlike examinees are, as far as answers can tell: two examinees at least, two answers each, not all
// alike.
std::optional<BetaBinomial> spread_of(const CellResult& cell, double chance, double level) {
  std::vector<ExamineeCount> answered;
  for (const ExamineeCount& count : cell.by_examinee)
    if (count.trials > 0) answered.push_back(count);
  const bool repeated =
      std::ranges::any_of(answered, [](const ExamineeCount& count) { return count.trials > 1; });
  if (answered.size() < 2 || !repeated || cell.correct == 0 || cell.correct == cell.trials)
    return std::nullopt;
  return beta_binomial(answered, {.chance = chance, .corrected = false, .level = level});
}

void test_cell(CellResult& cell, const Counts& counts, std::size_t index, const StudyReport& report) {
  if (cell.trials == 0) return;
  const OrderCounts& orders = counts.orders[index];
  const double level = report.options.level;
  std::vector<OrderStratum> sittings;
  for (const auto& [session, sitting] : counts.sittings[index]) sittings.push_back(sitting);
  cell.primary = primary_test(report.design, sittings, level, report.look);
  cell.over_examinees = interval_over_examinees(cell.by_examinee, level);
  cell.spread = spread_of(cell, report.design.chance, level);
  cell.d_prime = dprime_2ifc(cell.correct, cell.trials, DPrimeCorrection::HalfTrial, level);
  cell.bias = interval_bias(orders, DPrimeCorrection::HalfTrial, level);
  // Each examinee weighs the same here, so one who has only begun has no place.
  std::vector<ExamineeCount> answered;
  for (std::size_t i = 0; i < report.examinees.size(); ++i)
    if (report.is_complete[i] && cell.by_examinee[i].trials > 0) answered.push_back(cell.by_examinee[i]);
  if (!answered.empty())
    cell.by_people = examinee_level_test(answered, report.design.chance, {.level = level});
}

CellComparison compare(const Contrast& contrast, bool planned, const StudyReport& report) {
  CellComparison comparison{.contrast = contrast, .planned = planned ? report.design.between_models : "none"};
  std::vector<double> differences;
  std::vector<ExamineeCount> counts(report.cells.size());
  double sum = 0.0;
  for (std::size_t i = 0; i < report.examinees.size(); ++i) {
    if (!report.is_complete[i]) continue;
    for (std::size_t c = 0; c < counts.size(); ++c) counts[c] = report.cells[c].by_examinee[i];
    const std::optional<double> difference = contrast_of(contrast, counts);
    if (!difference) continue;
    differences.push_back(*difference);
    sum += *difference;
  }
  comparison.examinees = differences.size();
  if (differences.empty()) return comparison;
  comparison.mean_difference = sum / static_cast<double>(differences.size());
  if (report.withheld) return comparison;
  comparison.sign_flip = sign_flip_test(differences, {.level = report.options.level});
  if (differences.size() <= kLargestSignedRank) {
    comparison.signed_rank = signed_rank_test(differences, Zeros::Pratt, report.options.level);
  }
  return comparison;
}

void compare_cells(StudyReport& report) {
  const std::size_t planned = planned_contrasts(report.design);
  for (const Contrast& contrast : contrasts(report.design))
    report.comparisons.push_back(compare(contrast, report.comparisons.size() < planned, report));
  adjust_comparisons(report);
}

void take_sessions(const StudyTable& table, const Selection& selection, StudyReport& report) {
  for (std::size_t i = 0; i < table.sessions.size(); ++i) {
    if (selection.sessions[i]) report.sessions.push_back(table.sessions[i]);
  }
  report.pseudo_haptic = report.sessions.front().pseudo_haptic;
  report.channel = report.sessions.front().channel;
  for (const TrialRow* trial : selection.voided) {
    const ReportedSession& session = table.sessions[trial->session];
    report.voided.push_back({.examinee = session.examinee,
                             .cell = table.design.cells[trial->cell].name,
                             .reason = trial->void_reason,
                             .session = session.session,
                             .trial = trial->trial});
  }
  std::ranges::copy_if(table.curves, std::back_inserter(report.curves),
                       [&](const ForceCurve& curve) { return curve.run_mode == selection.run_mode; });
}

// Which answers the tests count. Whoever reads the results and goes on past the plan until they look well
// would make false positives more frequent than alpha: so the planned number of examinees counts, and at a
// look the number that it was planned at, in the order of completion.
std::vector<const TrialRow*> take_sample(const Selection& selection, StudyReport& report) {
  const std::vector<Completion> complete = completions(report.design, selection);
  report.is_complete.assign(report.examinees.size(), false);
  for (const Completion& one : complete) report.is_complete[one.examinee] = true;
  report.complete_examinees = static_cast<long>(complete.size());
  report.complete = report.complete_examinees >= report.planned_examinees;
  report.look = look_due(report.design, report.complete_examinees);
  report.withheld = !report.complete && !report.look && !report.options.interim;
  if (!report.complete && !report.look) return selection.trials;
  report.sample = std::min(report.complete_examinees, report.planned_examinees);
  return answers_of_first(static_cast<std::size_t>(*report.sample), complete, report.design, selection);
}

void compute(const Selection& selection, StudyReport& report) {
  const std::vector<const TrialRow*> counted = take_sample(selection, report);
  for (const DesignCell& cell : report.design.cells) {
    report.cells.push_back(
        {.name = cell.name, .by_examinee = std::vector<ExamineeCount>(report.examinees.size())});
  }
  const Counts counts = count(selection, counted, report.cells);
  count_all(selection, report);
  for (std::size_t i = 0; i < report.cells.size(); ++i) {
    report.cells[i].response_times = response_times(counts.response_times[i]);
    if (!report.withheld) test_cell(report.cells[i], counts, i, report);
  }
  if (!report.withheld) {
    adjust_cells(report);
    const auto learnt = learning(selection, counted, report.cells.size(), report.options.level);
    for (std::size_t i = 0; i < report.cells.size(); ++i) {
      CellResult& cell = report.cells[i];
      cell.learning = learnt[i];
      if (verdict(report, cell) == Verdict::NotShown)
        cell.evidence = evidence_for_chance(*cell.primary, report.options.level);
    }
  }
  compare_cells(report);
}

// The looks at results of this run mode: who looks at what simulated observers answer has seen nothing of the
// study. Of a planned look the first time counts; it gives the same whenever it is taken again.
void take_looks(const StudyTable& table, StudyReport& report) {
  std::map<int, LookEvent> planned;
  const auto take = [&](const LookEvent& look) {
    const auto [first, is_new] = planned.try_emplace(look.planned, look);
    if (!is_new && came_before(look.written, look.utc, first->second.written, first->second.utc))
      first->second = look;
  };
  for (const LookEvent& look : table.looks) {
    if (!look.run_mode.empty() && look.run_mode != report.run_mode) continue;
    if (look.planned > 0)
      take(look);
    else
      report.interim_looks.push_back(look);
  }
  if (report.look && !planned.contains(report.look->number))
    take({.run_mode = report.run_mode, .planned = report.look->number, .utc = report.options.written_utc});
  for (const auto& [number, look] : planned) report.planned_looks.push_back(look);
}

}  // namespace

StudyReport analyse(const StudyTable& table, const ReportOptions& options) {
  validate(table);
  require_level(options.level, "confidence level");
  const Selection selection = select(table, options);
  StudyReport report{.design = table.design,
                     .options = options,
                     .run_mode = selection.run_mode,
                     .planned_examinees = table.design.planned_examinees,
                     .examinees = selection.examinees,
                     .parts = table.parts,
                     .frozen_plans = table.frozen_plans};
  take_sessions(table, selection, report);
  compute(selection, report);
  take_looks(table, report);
  report.stimuli = summarise_stimuli(table.design, selection);
  if (report.withheld) withhold_results(report);
  write_sentences(table.notes, report);
  return report;
}

}  // namespace palpate::analysis
