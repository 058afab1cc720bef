#include "app/study/study_plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "analysis/binomial/to_json.hpp"
#include "analysis/detection/dprime.hpp"
#include "analysis/report/verdict.hpp"
#include "analysis/words/words.hpp"
#include "app/study/study_table.hpp"

namespace palpate::app {
namespace {

using namespace analysis;
using nlohmann::ordered_json;

constexpr double kTargetPower = 0.8;
constexpr long kLargestSize =
    2000;  // trials searched; 55 % correct, the smallest effect listed, needs some 620

constexpr long kMostTrials = 20'000;  // in a cell: the time of exact power grows with their square
constexpr long kMostBalanced = 500;   // and so does that of each of the simulated studies

void require_size(const trials::Protocol& protocol, bool coin) {
  const long each = protocol.trials_per_examinee_per_cell, most = coin ? kMostTrials : kMostBalanced;
  if (each * protocol.planned_examinees <= most) return;
  throw std::invalid_argument(
      fmt::format("{}: {} trials in a cell ({} with {} each); accepted: up to {}{}, for every "
                  "number of correct answers is counted; --studies plays studies of any size",
                  protocol.name, each * protocol.planned_examinees,
                  counted(protocol.planned_examinees, "examinee", "examinees"), each, most,
                  coin ? "" : " with balanced orders"));
}

// True proportions between chance and certainty, at the multiples of 5 %, on the side that the test looks at.
std::vector<double> proportions(double chance, Side side) {
  std::vector<double> values;
  for (int percent = 5; percent <= 95; percent += 5) {
    const double share = percent / 100.0;
    if (side == Side::Less ? share < chance : share > chance) values.push_back(share);
  }
  if (side == Side::Less) std::ranges::reverse(values);
  return values;
}

std::vector<PlannedLook> looks_of(const StudyDesign& design, double chance) {
  if (design.looks.empty()) return {};
  std::vector<long> trials;
  for (const int look : design.looks) trials.push_back(long{look} * design.trials_per_examinee_per_cell);
  return planned_looks(trials, chance, design.alpha, side_from_name(design.side),
                       spending_from_name(design.spending));
}

std::string examinees(const std::optional<SampleSize>& size, bool lasting, long each) {
  if (!size) return "n/a";
  const std::optional<long>& trials = lasting ? size->lasting : size->first;
  return trials ? std::to_string(*trials / each) : "more than asked";
}

std::string region(const CriticalNumber& critical) {
  std::string text;
  if (critical.at_least) text += fmt::format("{} or more correct reject guessing", *critical.at_least);
  if (critical.at_least && critical.at_most) text += ", and ";
  if (critical.at_most) text += fmt::format("{} or fewer correct reject guessing", *critical.at_most);
  return text.empty() ? "no number of correct answers rejects guessing" : text;
}

/// What the adjustment over the cells leaves where the other cells reject as well.
std::string at_best(const StudyPlan& plan) {
  if (!plan.critical_at_best) return "";
  return fmt::format("; if all other cells reject: {}", region(*plan.critical_at_best));
}

std::string regions_in_words(const StudyPlan& plan) {
  std::string text;
  const long each = plan.protocol.trials_per_examinee_per_cell;
  for (const trials::Cell& cell : plan.protocol.cells) {
    if (plan.critical && plan.looks.empty()) {
      text += fmt::format("{}: {}; {} (probability under guessing {}){}\n", cell.name,
                          counted(plan.critical->trials, "trial", "trials"), region(*plan.critical),
                          number(plan.critical->size), at_best(plan));
    } else if (plan.looks.empty()) {
      text += fmt::format(
          "{}: {}; the number that rejects guessing depends on how often either interval is "
          "answered, and is in the report\n",
          cell.name, counted(each * plan.protocol.planned_examinees, "trial", "trials"));
    }
    for (std::size_t i = 0; i < plan.looks.size(); ++i) {
      const PlannedLook& look = plan.looks[i];
      text += fmt::format(
          "{}, look {} of {} at {}: {}; {} (by now rejected under guessing: {})\n", cell.name, i + 1,
          plan.looks.size(), counted(look.critical.trials / each, "examinee", "examinees"),
          counted(look.critical.trials, "trial", "trials"), region(look.critical), number(look.size));
    }
  }
  return text;
}

bool adjusts(const StudyPlan& plan) {
  return plan.protocol.analysis.adjust != trials::Adjust::None;
}

std::string closing_words(const StudyPlan& plan) {
  const bool balanced = plan.protocol.interval_order == trials::IntervalOrder::Balanced;
  std::string text = balanced
                         ? fmt::format(
                               "Power of the randomisation test over the balanced orders, from {} simulated "
                               "studies: standard error at most {}. ",
                               plan.rows[0].alike.studies, number(0.5 / 100))
                         : std::string("Exact power of the primary test for each cell. ");
  if (adjusts(plan))
    text += "It is the power if no other cell rejects, the least that the adjustment leaves. ";
  text += "\"alike\": were every answer correct with the same probability. ";
  if (plan.overdispersion > 0) {
    text += fmt::format(
        "\"differing\": examinees' probabilities are beta-distributed around it with overdispersion {}. ",
        plan.overdispersion);
  } else {
    text += "Examinees differ, so a real study has less: --overdispersion 0.1 shows by how much. ";
  }
  if (!balanced) {
    text +=
        "Power rises in a sawtooth: with the first number of examinees it reaches 80 % first, from the last "
        "one on no larger study falls below it again";
    text += plan.looks.empty() ? "." : " (both for one test at the end).";
  }
  return wrapped(text);
}

ordered_json json_of(const Power& power) {
  return {{"power", power.power},
          {"overdispersion", power.overdispersion},
          {"standard_error", power.standard_error},
          {"simulated_studies", power.studies}};
}

ordered_json json_of(const PowerRow& row, long each) {
  const auto people = [&](bool lasting) -> ordered_json {
    if (!row.size) return nullptr;
    const std::optional<long>& trials = lasting ? row.size->lasting : row.size->first;
    return trials ? ordered_json(*trials / each) : ordered_json(nullptr);
  };
  return {{"probability", row.alike.probability},
          {"d_prime", row.d_prime},
          {"power", row.alike.power},
          {"alike", json_of(row.alike)},
          {"differing", json_of(row.differing)},
          {"examinees_first", people(false)},
          {"examinees_lasting", people(true)},
          {"sample_size", row.size ? analysis::to_json(*row.size) : ordered_json(nullptr)}};
}

void set_critical(const StudyDesign& design, double chance, StudyPlan& plan) {
  const long trials = long{design.trials_per_examinee_per_cell} * design.planned_examinees;
  const Side side = side_from_name(design.side);
  plan.critical = critical_number(trials, chance, strictest_alpha(design), side);
  if (design.adjust != "none") plan.critical_at_best = critical_number(trials, chance, design.alpha, side);
}

}  // namespace

StudyPlan planned_regions(const trials::Protocol& protocol) {
  StudyPlan plan{.protocol = protocol};
  const StudyDesign design = design_of(protocol);
  require_size(protocol, protocol.interval_order == trials::IntervalOrder::Coin);
  plan.looks = looks_of(design, protocol.task->chance);
  if (!plan.looks.empty())
    plan.critical = plan.looks.back().critical;
  else if (protocol.interval_order == trials::IntervalOrder::Coin)
    set_critical(design, protocol.task->chance, plan);
  return plan;
}

StudyPlan study_plan(const trials::Protocol& protocol, double overdispersion) {
  StudyPlan plan = planned_regions(protocol);
  plan.overdispersion = overdispersion;
  const StudyDesign design = design_of(protocol);
  const long each = protocol.trials_per_examinee_per_cell;
  const double chance = protocol.task->chance, alpha = strictest_alpha(design);
  const Side side = side_from_name(design.side);
  const bool coin = protocol.interval_order == trials::IntervalOrder::Coin;
  for (const double probability : proportions(chance, side)) {
    PowerRow row{.alike = primary_power(design, probability)};
    row.differing = overdispersion == 0 ? row.alike : primary_power(design, probability, overdispersion);
    row.d_prime = protocol.task->d_prime(std::lround(100 * probability), 100);
    if (coin)
      row.size =
          binomial_sample_size(chance, probability, alpha, side, kTargetPower, each, kLargestSize + each);
    plan.rows.push_back(row);
  }
  return plan;
}

std::string in_words(const StudyPlan& plan) {
  const trials::Protocol& protocol = plan.protocol;
  const long each = protocol.trials_per_examinee_per_cell;
  const auto cells = static_cast<long>(protocol.cells.size());
  std::string text = fmt::format("{}: {} in each of {}, {} for an examinee; {} planned\n", protocol.name,
                                 counted(each, "trial", "trials"), counted(cells, "cell", "cells"),
                                 counted(each * cells, "trial", "trials"),
                                 counted(protocol.planned_examinees, "examinee", "examinees"));
  text += fmt::format("Primary test: {}, alpha {}, side {}{}\n\n", to_string(protocol.analysis.primary),
                      protocol.analysis.alpha, to_string(protocol.analysis.side),
                      adjusts(plan) ? fmt::format(", p adjusted over the cells after {}",
                                                  adjustment_in_words(to_string(protocol.analysis.adjust)))
                                    : "");
  text += regions_in_words(plan);
  const bool differing = plan.overdispersion > 0;
  text += fmt::format("\n{:>14}  {:>5}  {:>12}{}  {:>20}  {:>22}\n", "true correct", "d'", "power, alike",
                      differing ? fmt::format("  {:>9}", "differing") : "", "examinees for 80 %",
                      "... and any more do");
  for (const PowerRow& row : plan.rows) {
    text += fmt::format("{:>14}  {:>5}  {:>12}{}  {:>20}  {:>22}\n", percent(row.alike.probability),
                        decimals(row.d_prime, 2), decimals(row.alike.power, 4),
                        differing ? fmt::format("  {:>9}", decimals(row.differing.power, 4)) : "",
                        examinees(row.size, false, each), examinees(row.size, true, each));
  }
  return text + "\n" + closing_words(plan);
}

ordered_json to_json(const StudyPlan& plan) {
  const trials::Protocol& protocol = plan.protocol;
  const long each = protocol.trials_per_examinee_per_cell;
  ordered_json cells = ordered_json::array(), rows = ordered_json::array(), looks = ordered_json::array();
  for (const trials::Cell& cell : protocol.cells) {
    cells.push_back({{"cell", cell.name},
                     {"critical", plan.critical ? analysis::to_json(*plan.critical) : ordered_json(nullptr)},
                     {"critical_at_best", plan.critical_at_best ? analysis::to_json(*plan.critical_at_best)
                                                                : ordered_json(nullptr)}});
  }
  for (const PlannedLook& look : plan.looks) {
    looks.push_back({{"examinees", look.critical.trials / each},
                     {"critical", analysis::to_json(look.critical)},
                     {"rejected_by_now_under_guessing", look.size}});
  }
  for (const PowerRow& row : plan.rows) rows.push_back(json_of(row, each));
  return {{"protocol", protocol.name},
          {"sha256", protocol.sha256},
          {"planned_examinees", protocol.planned_examinees},
          {"trials_per_examinee_per_cell", each},
          {"trials_per_cell", each * protocol.planned_examinees},
          {"primary", to_string(protocol.analysis.primary)},
          {"alpha", protocol.analysis.alpha},
          {"side", to_string(protocol.analysis.side)},
          {"adjust", to_string(protocol.analysis.adjust)},
          {"cells", cells},
          {"looks", looks},
          {"target_power", kTargetPower},
          {"power", rows}};
}

}  // namespace palpate::app
