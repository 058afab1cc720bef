#include <nlohmann/json.hpp>

#include "analysis/binomial/to_json.hpp"
#include "analysis/detection/to_json.hpp"
#include "analysis/numerics/to_json.hpp"
#include "analysis/report/deviations.hpp"
#include "analysis/report/verdict.hpp"
#include "analysis/report/write_report.hpp"
#include "analysis/resampling/to_json.hpp"
#include "analysis/statistics/examinee_level/to_json.hpp"
#include "analysis/statistics/interval_bias/to_json.hpp"
#include "analysis/statistics/wilcoxon/to_json.hpp"

namespace palpate::analysis {

using nlohmann::ordered_json;

namespace {

ordered_json primary_json(const PrimaryTest& test) {
  ordered_json look = nullptr;
  if (test.look) {
    look = {{"number", test.look->number},
            {"of", test.look->of},
            {"alpha_spent", test.look->spent},
            {"rejected_by_now_under_guessing", test.size}};
  }
  return {{"procedure", test.name == "paired-comparison" ? "binomial" : "randomisation"},
          {"correct", test.correct},
          {"trials", test.trials},
          {"chance", test.chance},
          {"side", name_of(test.side)},
          {"proportion", test.proportion},
          {"p", test.p.of(test.side)},
          {"p_values", to_json(test.p)},
          {"interval", to_json(test.interval)},
          {"bound", to_json(test.bound)},
          {"wilson", to_json(test.wilson)},
          {"look", look},
          {"method", to_json(test.method)}};
}

template <typename Result>
ordered_json or_null(const std::optional<Result>& result) {
  return result ? to_json(*result) : ordered_json(nullptr);
}

template <typename Value>
ordered_json plain_or_null(const std::optional<Value>& value) {
  return value ? ordered_json(*value) : ordered_json(nullptr);
}

ordered_json design_json(const StudyDesign& design) {
  ordered_json cells = ordered_json::array();
  for (const DesignCell& cell : design.cells) cells.push_back({{"name", cell.name}, {"levels", cell.levels}});
  ordered_json json = {
      {"question", design.question},
      {"task", design.task},
      {"conditions", design.conditions},
      {"correct_condition", design.correct_condition},
      {"factors", design.factors},
      {"cells", cells},
      {"procedure", design.procedure},
      {"trials_per_examinee_per_cell", design.trials_per_examinee_per_cell},
      {"planned_examinees", design.planned_examinees},
      {"cell_order", design.cell_order},
      {"interval_order", design.interval_order},
      {"primary", design.primary},
      {"alpha", design.alpha},
      {"side", design.side},
      {"adjust", design.adjust},
      {"between_models", design.between_models},
      {"looks", design.looks},
      {"spending", design.looks.empty() ? ordered_json(nullptr) : ordered_json(design.spending)},
      {"display_during_interval", design.display_during_interval}};
  if (design.feedback_s > 0) json["feedback_s"] = design.feedback_s;
  return json;
}

ordered_json spread_json(const std::optional<BetaBinomial>& spread) {
  if (!spread) return nullptr;
  return {{"gamma", to_json(spread->gamma.estimate)},
          {"interval", to_json(spread->gamma.interval)},
          {"likelihood_ratio",
           {{"g_squared", spread->overdispersion.g_squared}, {"p", spread->overdispersion.p}}},
          {"tarone", {{"z", spread->tarone.z}, {"p", spread->tarone.p}}},
          {"method", to_json(spread->method)}};
}

ordered_json times_json(const std::optional<ResponseTimes>& times) {
  if (!times) return nullptr;
  return {{"n", times->n},
          {"least", times->least},
          {"lower_quartile", times->lower_quartile},
          {"median", times->median},
          {"upper_quartile", times->upper_quartile},
          {"most", times->most}};
}

ordered_json plan_json(const StudyReport& report) {
  ordered_json frozen = ordered_json::array();
  for (const FrozenPlan& plan : report.frozen_plans)
    frozen.push_back({{"sha256", plan.sha256},
                      {"frozen_utc", plan.frozen_utc},
                      {"software_version", plan.software_version},
                      {"frozen_in", part_in_words(report, plan.part)}});
  ordered_json looks = ordered_json::array();
  for (const LookEvent& look : report.planned_looks)
    looks.push_back({{"number", look.planned},
                     {"first_taken_utc", look.utc.empty() ? ordered_json(nullptr) : ordered_json(look.utc)}});
  return {{"frozen", frozen.empty() ? ordered_json(nullptr) : frozen.front()},
          {"frozen_plans", frozen},
          {"words", report.plan},
          {"deviations", report.deviations},
          {"planned_looks_taken", looks},
          {"unplanned_interim_looks", report.interim_looks.size()}};
}

ordered_json evidence_json(const std::optional<EvidenceForChance>& evidence) {
  if (!evidence) return nullptr;
  ordered_json similarity = nullptr;
  if (evidence->similarity) {
    const SimilarityTest& test = *evidence->similarity;
    similarity = {{"bound_discriminators", test.bound_discriminators},
                  {"bound", test.bound},
                  {"discriminators_up_to", test.discriminators_up_to},
                  {"p", test.p},
                  {"similar", test.similar}};
  }
  return {{"similarity", similarity},
          {"log_bayes_factor", to_json(evidence->bayes.log_bayes_factor)},
          {"in_words", evidence_in_words(evidence->bayes.log_bayes_factor)}};
}

ordered_json learning_json(const std::optional<Learning>& learning) {
  if (!learning) return nullptr;
  return {{"correct_first_half", learning->correct_first}, {"trials_first_half", learning->trials_first},
          {"correct_last_half", learning->correct_last},   {"trials_last_half", learning->trials_last},
          {"mean_difference", learning->mean_difference},  {"sign_flip", to_json(learning->sign_flip)}};
}

std::string_view kind_of(const Contrast& contrast) {
  switch (contrast.kind) {
    case Contrast::Kind::MainEffect:
      return "main effect";
    case Contrast::Kind::Interaction:
      return "interaction";
    case Contrast::Kind::Cells:
      break;
  }
  return "cells";
}

ordered_json cell_json(const StudyReport& report, const CellResult& cell) {
  ordered_json examinees = ordered_json::array();
  for (std::size_t i = 0; i < report.examinees.size(); ++i) {
    const bool counted = cell.by_examinee[i].trials > 0 || !cell.all;
    const ExamineeCount& count = counted ? cell.by_examinee[i] : cell.all->by_examinee[i];
    examinees.push_back({{"examinee", report.examinees[i]},
                         {"correct", report.withheld ? ordered_json() : ordered_json(count.correct)},
                         {"trials", count.trials},
                         {"counted", counted}});
  }
  ordered_json all = nullptr;
  if (cell.all && !report.withheld) all = {{"correct", cell.all->correct}, {"trials", cell.all->trials}};
  const bool tested = cell.primary.has_value();
  return {{"cell", cell.name},
          {"correct", report.withheld ? ordered_json() : ordered_json(cell.correct)},
          {"trials", cell.trials},
          {"voided", cell.voided},
          {"all_answers", all},
          {"significant", tested ? ordered_json(rejects_guessing(report, cell)) : ordered_json(nullptr)},
          {"verdict", report.withheld ? ordered_json() : ordered_json(in_words(verdict(report, cell)))},
          {"p_adjusted", plain_or_null(cell.p_adjusted)},
          {"primary", tested ? primary_json(*cell.primary) : ordered_json(nullptr)},
          {"critical", tested ? to_json(cell.primary->critical) : ordered_json(nullptr)},
          {"interval_over_examinees", or_null(cell.over_examinees)},
          {"evidence_for_chance", evidence_json(cell.evidence)},
          {"examinee_level", or_null(cell.by_people)},
          {"overdispersion", spread_json(cell.spread)},
          {"dprime", or_null(cell.d_prime)},
          {"interval_order", or_null(cell.bias)},
          {"median_response_time_s",
           cell.response_times ? ordered_json(cell.response_times->median) : ordered_json(nullptr)},
          {"response_times_s", times_json(cell.response_times)},
          {"learning", learning_json(cell.learning)},
          {"by_examinee", examinees}};
}

ordered_json comparison_json(const CellComparison& comparison) {
  const Contrast& contrast = comparison.contrast;
  return {{"comparison", name_of(contrast)},
          {"kind", kind_of(contrast)},
          {"first", contrast.first},
          {"second", contrast.second},
          {"weights", contrast.weights},
          {"divisor", contrast.divisor},
          {"examinees", comparison.examinees},
          {"mean_difference",
           comparison.examinees > 0 ? to_json(comparison.mean_difference) : ordered_json(nullptr)},
          {"planned", comparison.planned},
          {"p_adjusted", plain_or_null(comparison.p_adjusted)},
          {"sign_flip", or_null(comparison.sign_flip)},
          {"wilcoxon", or_null(comparison.signed_rank)}};
}

ordered_json stimulus_json(const StimulusSummary& stimulus) {
  return {{"cell", stimulus.cell},
          {"condition", stimulus.condition},
          {"intervals", stimulus.intervals},
          {"shown_again", stimulus.shown_again},
          {"mean_presses", stimulus.mean_presses},
          {"mean_exploration_time_s", or_null(stimulus.mean_exploration_s)},
          {"mean_peak_force_n", or_null(stimulus.mean_peak_force_n)},
          {"mean_max_depth_m", or_null(stimulus.mean_max_depth_m)},
          {"worst_clamped_fraction", or_null(stimulus.worst_clamped_fraction)},
          {"worst_loop_p999_ms", or_null(stimulus.worst_loop_p999_ms)},
          {"missed_cycles", plain_or_null(stimulus.missed_cycles)},
          {"worst_force_error_bound_n", or_null(stimulus.worst_force_error_bound_n)},
          {"cycles_within_tolerance", plain_or_null(stimulus.cycles_within_tolerance)},
          {"cycles_at_cap", plain_or_null(stimulus.cycles_at_cap)}};
}

ordered_json session_json(const ReportedSession& session) {
  return {{"session", session.session},
          {"examinee", session.examinee},
          {"run_mode", session.run_mode},
          {"started_utc", session.started_utc},
          {"finished", session.finished},
          {"times_resumed", session.times_resumed},
          {"device", session.device},
          {"pseudo_haptic", session.pseudo_haptic},
          {"channel", session.channel},
          {"force_scale", session.force_scale},
          {"order_source", session.order_source},
          {"protocol_sha256", session.protocol_sha256},
          {"software_version", session.software_version},
          {"later_software_versions", session.later_versions}};
}

ordered_json curve_json(const StudyReport& report, const ForceCurve& curve) {
  return {{"cell", report.design.cells[curve.cell].name},
          {"condition", curve.condition},
          {"intervals", curve.intervals},
          {"depth_m", curve.depth_m},
          {"mean_force_n", curve.mean_force_n},
          {"standard_deviation_n", curve.deviation_n}};
}

template <typename Rows, typename Writer>
ordered_json array_of(const Rows& rows, Writer writer) {
  ordered_json array = ordered_json::array();
  for (const auto& row : rows) array.push_back(writer(row));
  return array;
}

}  // namespace

ordered_json json_report(const StudyReport& report) {
  const auto cell = [&](const CellResult& result) { return cell_json(report, result); };
  const auto curve = [&](const ForceCurve& row) { return curve_json(report, row); };
  const auto voided = [](const VoidedTrial& trial) -> ordered_json {
    return {{"examinee", trial.examinee},
            {"session", trial.session},
            {"trial", trial.trial},
            {"cell", trial.cell},
            {"reason", trial.reason}};
  };
  return {{"report", "palpate significance report"},
          {"format_version", 1},
          {"protocol", {{"name", report.design.protocol_name}, {"sha256", report.design.protocol_sha256}}},
          {"run_mode", report.run_mode},
          {"pseudo_haptic", report.pseudo_haptic},
          {"channel", report.channel},
          {"interim", report.options.interim && !report.complete && !report.look},
          {"withheld", report.withheld},
          {"planned_examinees", report.planned_examinees},
          {"complete_examinees", report.complete_examinees},
          {"counted_examinees", plain_or_null(report.sample)},
          {"banners", report.banners},
          {"summary", report.summary},
          {"design", design_json(report.design)},
          {"cells", array_of(report.cells, cell)},
          {"comparisons", array_of(report.comparisons, comparison_json)},
          {"claims",
           {{"pooled", report.pooled_claim},
            {"examinee_level", report.people_claim},
            {"comparison", report.comparison_claim}}},
          {"stimuli", array_of(report.stimuli, stimulus_json)},
          {"force_curves", array_of(report.curves, curve)},
          {"voided", array_of(report.voided, voided)},
          {"plan", plan_json(report)},
          {"method", report.method},
          {"limits", report.limits},
          {"sessions", array_of(report.sessions, session_json)},
          {"software_version", report.options.software_version},
          {"written_utc", report.options.written_utc},
          {"receipt", report.options.receipt}};
}

}  // namespace palpate::analysis
