#pragma once

#include <functional>
#include <span>
#include <string_view>
#include <vector>

#include "trials/adaptive/adaptive.hpp"
#include "trials/adaptive/level_reader.hpp"

namespace palpate::trials {

/// A parameter's values on a grid, rising, and how likely each is beforehand.
struct GridParameter {
  std::string_view name;
  std::vector<double> values{};
  std::vector<double> prior{};  // sums to 1
};

/// Levels and parameters on grids. The next level is the one after whose answer the parameters are expected
/// to be least uncertain: what psi [KontsevichTyler1999] and QUEST+ [Watson2017] share.
struct EntropyDesign : AdaptiveDesign {
  std::vector<double> levels{};             // rising
  std::vector<GridParameter> parameters{};  // a combination has one value of each; the last runs fastest
  std::vector<double> prior{};              // of each combination, sums to 1
  std::vector<double> share_correct{};      // of each level and combination, level-major
  std::vector<double> answer_entropy{};     // the same [bit]
};

/// The most pairs of a level and a combination. The time of a choice is in proportion to it.
inline constexpr std::size_t kMostPairs = 2'000'000;

/// Levels whose expected entropies differ by less count as alike, and the lowest of them is taken: some units
/// in the last place of the answer's entropy. Watson's second example tells levels apart that differ by 1e-14
/// [bit].
inline constexpr double kSameEntropy = 1e-15;

/// Of a combination's values, in the order of the parameters: the share correct at a level.
using ShareCorrect = std::function<double(double level, std::span<const double> values)>;

/// Fills prior, share_correct and answer_entropy from levels and parameters.
void prepare(EntropyDesign& design, const ShareCorrect& share_correct);

/// Refuses what exceeds kMostPairs, at a key.
void refuse_too_many(LevelReader& reader, std::string_view key, const EntropyDesign& design);

/// Rising levels or numbers; others are refused.
void refuse_unless_rising(const LevelReader& reader, std::string_view key, std::span<const double> values);

void begin_by_entropy(const AdaptiveDesign& design, AdaptiveRun& run);
std::optional<double> next_by_entropy(const AdaptiveDesign& design, const AdaptiveRun& run);
/// Throws std::invalid_argument for an answer that no combination allows.
void tell_by_entropy(const AdaptiveDesign& design, AdaptiveRun& run, const AdaptiveAnswer& answer);
Belief belief_by_entropy(const AdaptiveDesign& design, const AdaptiveRun& run);

}  // namespace palpate::trials
