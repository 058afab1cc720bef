#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "trials/protocol/protocol.hpp"
#include "trials/protocol/stimuli.hpp"

namespace palpate::app {

/// What there is to be felt in a cell, pressed without trembling from the depth that the protocol asks for to
/// the scene's.
struct StimulusCheck {
  std::string cell{};
  std::vector<std::string> conditions{};     // that are presented
  double depth = 0.0;                        // where they differ most [m]
  std::vector<double> forces{};              // of each there, against the press [N]
  double difference = 0.0;                   // of the largest from the smallest there, of the smaller one [-]
  bool answer_misleads = false;              // the wrong condition is what the question asks for
  std::optional<double> expected_correct{};  // of simulated people; nothing where the answer is not known
  std::optional<double> power{};             // of the primary test, were they to answer so
};

/// @param stimuli  compiled; null where no trial presents one
std::vector<StimulusCheck> check_stimuli(const trials::Protocol& protocol, const trials::Stimuli& stimuli);

/// What will disappoint whoever runs this study, a sentence each.
std::vector<std::string> stimulus_warnings(const trials::Protocol& protocol,
                                           const std::vector<StimulusCheck>& cells);

void print_text(const trials::Protocol& protocol, const std::vector<StimulusCheck>& cells);
nlohmann::ordered_json to_json(const std::vector<StimulusCheck>& cells);

}  // namespace palpate::app
