#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "analysis/report/primary_power.hpp"
#include "app/commands/check/check_stimulus.hpp"
#include "app/study/study_plan.hpp"
#include "trials/protocol/protocol.hpp"

namespace palpate::app {

struct ProtocolCheck {
  trials::Protocol protocol{};
  trials::PlanSummary plan{};
  StudyPlan regions{};
  analysis::Power power{};               // when an effect of middling size is there
  std::vector<StimulusCheck> stimuli{};  // a cell each
  std::vector<std::string> warnings{};
};

/// Reads everything that a session will need, so that what is sound here also runs.
ProtocolCheck check_protocol(const std::string& file);

void print_text(const ProtocolCheck& check);
nlohmann::ordered_json to_json(const ProtocolCheck& check);

}  // namespace palpate::app
