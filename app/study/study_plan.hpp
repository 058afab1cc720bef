#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <vector>

#include "analysis/binomial/binomial_power.hpp"
#include "analysis/report/primary_power.hpp"
#include "analysis/statistics/looks/planned_looks.hpp"
#include "trials/protocol/protocol.hpp"

namespace palpate::app {

/// Power of the planned study, and the examinees that it takes, for one true proportion correct.
struct PowerRow {
  double d_prime = 0.0;         // of an unbiased observer in the study's task
  analysis::Power alike{};      // were all examinees alike
  analysis::Power differing{};  // with the overdispersion that was asked for
  /// Of the binomial test without looks; balanced orders have none.
  std::optional<analysis::SampleSize> size{};
};

/// What a protocol amounts to before anybody has sat it.
struct StudyPlan {
  trials::Protocol protocol{};
  /// At the end; empty where it depends on the answers. Where the cells' p values are adjusted: what rejects in
  /// a cell whatever the others give.
  std::optional<analysis::CriticalNumber> critical{};
  std::optional<analysis::CriticalNumber> critical_at_best{};  // adjusted: where all other cells reject
  std::vector<analysis::PlannedLook> looks{};
  double overdispersion = 0.0;
  std::vector<PowerRow> rows{};
};

/// The plan without power: critical number and looks, which take no time.
StudyPlan planned_regions(const trials::Protocol& protocol);

/// @param overdispersion  gamma of the examinees' probabilities, 0 to 1
StudyPlan study_plan(const trials::Protocol& protocol, double overdispersion);

std::string in_words(const StudyPlan& plan);
nlohmann::ordered_json to_json(const StudyPlan& plan);

}  // namespace palpate::app
