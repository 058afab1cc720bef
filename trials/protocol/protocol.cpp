#include "trials/protocol/protocol.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace palpate::trials {

constexpr std::size_t kMostCells = 1000;  // more is a slip of the keyboard

namespace {

/// Levels of each factor in cell number `cell`, the last factor fastest.
std::vector<std::size_t> levels_of(const std::vector<Factor>& factors, std::size_t cell) {
  std::vector<std::size_t> levels(factors.size());
  for (std::size_t i = factors.size(); i-- > 0;) {
    levels[i] = cell % factors[i].levels.size();
    cell /= factors[i].levels.size();
  }
  return levels;
}

Cell make_cell(const std::vector<Factor>& factors, std::size_t number) {
  Cell cell{.name = factors.empty() ? "all" : "", .levels = levels_of(factors, number)};
  for (std::size_t i = 0; i < factors.size(); ++i)
    cell.name += (i > 0 ? ", " : "") + factors[i].levels[cell.levels[i]].name;
  return cell;
}

Stimulus make_stimulus(const Protocol& protocol, std::size_t cell, std::size_t condition) {
  Stimulus stimulus{.cell = cell, .condition = condition, .overrides = {}};
  for (std::size_t i = 0; i < protocol.factors.size(); ++i) {
    const auto& changes = protocol.factors[i].levels[protocol.cells[cell].levels[i]].overrides;
    stimulus.overrides.insert(stimulus.overrides.end(), changes.begin(), changes.end());
  }
  const auto& changes = protocol.conditions[condition].overrides;
  stimulus.overrides.insert(stimulus.overrides.end(), changes.begin(), changes.end());
  return stimulus;
}

}  // namespace

int trials_per_session(const Protocol& protocol) {
  return static_cast<int>(protocol.cells.size()) * protocol.trials_per_examinee_per_cell;
}

int minutes_of(const Protocol& protocol) {
  const double interval = std::min(protocol.exploration.max_time, 8.0) + 2.0;
  const double question =
      protocol.task->intervals * interval + 5.0 + (protocol.feedback ? kFeedbackTime : 0.0);
  return static_cast<int>(std::ceil(trials_per_session(protocol) * question / 60.0));
}

std::size_t stimulus_index(const Protocol& protocol, std::size_t cell, std::size_t condition) {
  return cell * protocol.conditions.size() + condition;
}

void expand(Protocol& protocol) {
  protocol.cells.clear();
  protocol.stimuli.clear();
  std::size_t count = 1;
  for (const Factor& factor : protocol.factors) {
    count *= factor.levels.size();
    if (count > kMostCells)
      throw std::invalid_argument(fmt::format("{}:{}: factors: make more than {} cells; accepted: at most {}",
                                              protocol.file.string(), factor.line, kMostCells, kMostCells));
  }
  for (std::size_t cell = 0; cell < count; ++cell) {
    protocol.cells.push_back(make_cell(protocol.factors, cell));
    for (std::size_t condition = 0; condition < protocol.conditions.size(); ++condition)
      protocol.stimuli.push_back(make_stimulus(protocol, cell, condition));
  }
}

PlanSummary describe(const Protocol& protocol) {
  PlanSummary summary;
  summary.trials_per_session = trials_per_session(protocol);
  summary.planned_examinees = protocol.planned_examinees;
  summary.trials_per_cell = protocol.planned_examinees * protocol.trials_per_examinee_per_cell;
  for (const Cell& cell : protocol.cells) summary.cells.push_back(cell.name);
  summary.best_guess = protocol.task->chance;
  summary.order = fmt::format("{} {}", protocol.procedure->order_in_words(protocol),
                              protocol.task->order_in_words(protocol));
  return summary;
}

std::string_view to_string(DuringInterval display) {
  return base::word_of(kDuringIntervalWords, display);
}
std::string_view to_string(CellOrder order) {
  return base::word_of(kCellOrderWords, order);
}
std::string_view to_string(IntervalOrder order) {
  return base::word_of(kIntervalOrderWords, order);
}
std::string_view to_string(PrimaryAnalysis analysis) {
  return base::word_of(kPrimaryAnalysisWords, analysis);
}
std::string_view to_string(Side side) {
  return base::word_of(kSideWords, side);
}
std::string_view to_string(Adjust adjust) {
  return base::word_of(kAdjustWords, adjust);
}

}  // namespace palpate::trials
