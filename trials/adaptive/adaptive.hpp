#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/text/key.hpp"

namespace palpate::trials {

class LevelReader;

/// When a run ends: after so many reversals or so many answers, what comes first; neither: never by itself.
struct StopRule {
  std::optional<int> reversals{}, trials{};
};

/// What an adaptive procedure has read of its [procedure] table, and what it computed from that once.
struct AdaptiveDesign {
  virtual ~AdaptiveDesign() = default;
  StopRule stop{};
};

/// An answer as an adaptive procedure hears of it: how the question was asked, and what came back.
struct AdaptiveAnswer {
  double level = 0.0;  // that was shown
  bool correct = false;
};

/// A trial after which levels went the other way.
struct Reversal {
  int trial = 0;       // from 1
  double level = 0.0;  // at which it was asked

  bool operator==(const Reversal&) const = default;
};

/// Where a run stands. Never stored: replay_adaptive() makes it anew from the answers.
struct AdaptiveRun {
  std::vector<double> memory{};  // what the procedure keeps, plain numbers
  std::vector<Reversal> reversals{};
  int told = 0;  // answers heard of

  bool operator==(const AdaptiveRun&) const = default;
};

/// What the answers so far say of one parameter.
struct ParameterBelief {
  std::string_view name;
  double mean = 0.0, mode = 0.0, sd = 0.0;  // of its marginal; the mode is that of all parameters together
};

/// What a Bayesian procedure holds true.
struct Belief {
  std::vector<ParameterBelief> parameters{};
  double entropy = 0.0;                      // of all parameters together [bit]
  std::optional<double> expected_entropy{};  // after the answer to the next question [bit]
};

/// A procedure that chooses the level of the next question from the answers before. The run follows from the
/// design and the answers alone.
struct AdaptiveProcedure {
  std::string_view name;     // procedure.kind
  std::string_view meaning;  // how levels are chosen, a clause
  std::span<const base::Key> keys{};
  /// [procedure], all but kind. What is refused throws std::invalid_argument.
  std::unique_ptr<const AdaptiveDesign> (*read)(LevelReader& procedure);
  void (*begin)(const AdaptiveDesign& design, AdaptiveRun& run);
  /// The level of the next question; nothing when the run is complete.
  std::optional<double> (*next)(const AdaptiveDesign& design, const AdaptiveRun& run);
  /// Hears of an answer. Called before AdaptiveRun::told is counted up.
  void (*tell)(const AdaptiveDesign& design, AdaptiveRun& run, const AdaptiveAnswer& answer);
  std::optional<double> (*mean_of_reversals)(const AdaptiveDesign& design, const AdaptiveRun& run) = nullptr;
  Belief (*belief)(const AdaptiveDesign& design, const AdaptiveRun& run) = nullptr;  // of Bayesian ones
  /// The threshold by the procedure's own rule, where it has one beside these; nothing before the end.
  std::optional<double> (*estimate)(const AdaptiveDesign& design, const AdaptiveRun& run) = nullptr;
};

/// Every adaptive procedure that there is. The list stands in trials/procedures/adaptive_procedures.cpp.
std::span<const AdaptiveProcedure* const> adaptive_procedures();

/// Whether the run has come to the end that its stop rule sets.
bool has_stopped(const StopRule& stop, const AdaptiveRun& run);

/// The level of the next question; nothing after the end.
std::optional<double> next_level(const AdaptiveProcedure& procedure, const AdaptiveDesign& design,
                                 const AdaptiveRun& run);

AdaptiveRun begin_adaptive(const AdaptiveProcedure& procedure, const AdaptiveDesign& design);

/// One answer more.
void tell_adaptive(const AdaptiveProcedure& procedure, const AdaptiveDesign& design, AdaptiveRun& run,
                   const AdaptiveAnswer& answer);

/// The run after these answers, in the order in which they were given.
AdaptiveRun replay_adaptive(const AdaptiveProcedure& procedure, const AdaptiveDesign& design,
                            std::span<const AdaptiveAnswer> answers);

}  // namespace palpate::trials
