#pragma once

#include <optional>
#include <string>
#include <vector>

#include "trials/adaptive/load_adaptive.hpp"

namespace palpate::app {

struct ReplayedTrial {
  double level = 0.0;
  bool correct = false;
  std::optional<trials::Belief> belief{};    // after the answer; Bayesian procedures have one
  std::optional<double> expected_entropy{};  // when the level was chosen, after its answer [bit]
};

/// A procedure that was given answers, each at the level that it asked for.
struct ReplayedRun {
  std::vector<ReplayedTrial> trials{};
  std::vector<trials::Reversal> reversals{};
  std::optional<double> next_level{}, mean_of_reversals{}, estimate{};
  std::optional<int> stopped_at{};  // the last trial
};

/// Throws std::invalid_argument for answers after the end.
ReplayedRun replay_answers(const trials::LoadedProcedure& loaded, const std::vector<bool>& answers);

/// "1,0,1": correct, wrong, correct. Throws std::invalid_argument for anything else.
std::vector<bool> parse_answers(const std::string& text);

}  // namespace palpate::app
