#include "trials/adaptive/entropy_choice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "trials/adaptive/psychometric.hpp"

namespace palpate::trials {
namespace {

// The memory: the level that comes next, what its answer is expected to leave, and how likely each
// combination is.
enum : std::size_t { kChosen, kExpectedEntropy, kPosterior };

const EntropyDesign& on_grid(const AdaptiveDesign& design) {
  return static_cast<const EntropyDesign&>(design);
}

std::span<const double> posterior_of(const AdaptiveRun& run) {
  return std::span(run.memory).subspan(kPosterior);
}

double entropy_of(std::span<const double> shares) {
  double bits = 0.0;
  for (const double share : shares)
    if (share > 0.0) bits -= share * std::log2(share);
  return bits;
}

/// The value of each parameter in the combination of this number.
std::vector<double> combination(const EntropyDesign& design, std::size_t number) {
  std::vector<double> values(design.parameters.size());
  for (std::size_t i = design.parameters.size(); i-- > 0;) {
    const std::size_t count = design.parameters[i].values.size();
    values[i] = design.parameters[i].values[number % count];
    number /= count;
  }
  return values;
}

/// A sum whose rounding does not grow with its length (Kahan's): levels far above threshold differ by 1e-14
/// bit.
struct ExactSum {
  double value = 0.0, lost = 0.0;

  void add(double term) {
    const double more = term - lost, sum = value + more;
    lost = (sum - value) - more;
    value = sum;
  }
};

/// What the answer at a level is expected to tell of the parameters [bit]: its entropy, less the mean of its
/// entropies had one combination been known to hold. So much less remains unknown; the sum that remains is
/// not needed for it.
double expected_gain(const EntropyDesign& design, std::span<const double> posterior, std::size_t level) {
  const std::size_t count = posterior.size();
  const double* share = design.share_correct.data() + level * count;
  const double* bits = design.answer_entropy.data() + level * count;
  ExactSum correct, known;
  for (std::size_t i = 0; i < count; ++i) {
    correct.add(posterior[i] * share[i]);
    known.add(posterior[i] * bits[i]);
  }
  return binary_entropy(correct.value) - known.value;
}

void choose(const EntropyDesign& design, AdaptiveRun& run) {
  const std::span<const double> posterior = posterior_of(run);
  std::vector<double> gains;
  for (std::size_t level = 0; level < design.levels.size(); ++level)
    gains.push_back(expected_gain(design, posterior, level));
  const double enough = std::ranges::max(gains) - kSameEntropy;
  const auto chosen = std::ranges::find_if(gains, [enough](double gain) { return gain >= enough; });
  run.memory[kChosen] = design.levels[static_cast<std::size_t>(chosen - gains.begin())];
  run.memory[kExpectedEntropy] = entropy_of(posterior) - *chosen;
}

}  // namespace

void prepare(EntropyDesign& design, const ShareCorrect& share_correct) {
  design.prior = {1.0};
  for (const GridParameter& parameter : design.parameters) {
    std::vector<double> finer;
    for (const double before : design.prior)
      for (const double share : parameter.prior) finer.push_back(before * share);
    design.prior = std::move(finer);
  }
  std::vector<std::vector<double>> combinations;
  for (std::size_t i = 0; i < design.prior.size(); ++i) combinations.push_back(combination(design, i));
  for (const double level : design.levels)
    for (const std::vector<double>& values : combinations) {
      design.share_correct.push_back(share_correct(level, values));
      design.answer_entropy.push_back(binary_entropy(design.share_correct.back()));
    }
}

void refuse_too_many(LevelReader& reader, std::string_view key, const EntropyDesign& design) {
  double pairs = static_cast<double>(design.levels.size());
  for (const GridParameter& parameter : design.parameters)
    pairs *= static_cast<double>(parameter.values.size());
  if (pairs > static_cast<double>(kMostPairs))
    reader.refuse(
        key, fmt::format("{:.0f} pairs of a level and a combination of parameters, accepted: up to {}", pairs,
                         kMostPairs));
}

void refuse_unless_rising(const LevelReader& reader, std::string_view key, std::span<const double> values) {
  const auto fall = std::ranges::adjacent_find(values, std::greater_equal<>());
  if (fall != values.end())
    reader.refuse(key, fmt::format("found {:g} after {:g}, accepted: rising values", *(fall + 1), *fall));
}

void begin_by_entropy(const AdaptiveDesign& design, AdaptiveRun& run) {
  const std::vector<double>& prior = on_grid(design).prior;
  run.memory.assign(kPosterior + prior.size(), 0.0);
  std::ranges::copy(prior, run.memory.begin() + kPosterior);
  choose(on_grid(design), run);
}

std::optional<double> next_by_entropy(const AdaptiveDesign&, const AdaptiveRun& run) {
  return run.memory[kChosen];
}

void tell_by_entropy(const AdaptiveDesign& all, AdaptiveRun& run, const AdaptiveAnswer& answer) {
  const EntropyDesign& design = on_grid(all);
  const auto found = std::ranges::lower_bound(design.levels, answer.level);
  if (found == design.levels.end() || *found != answer.level)
    throw std::logic_error(fmt::format("told of the level {}, which is not on the grid", answer.level));
  const auto level = static_cast<std::size_t>(found - design.levels.begin());
  const std::span<double> posterior = std::span(run.memory).subspan(kPosterior);
  const double* share = design.share_correct.data() + level * posterior.size();
  double sum = 0.0;
  for (std::size_t i = 0; i < posterior.size(); ++i)
    sum += posterior[i] *= answer.correct ? share[i] : 1.0 - share[i];
  if (!(sum > 0.0))
    throw std::invalid_argument(fmt::format(
        "answer {}: {} at {:g} has no chance with any of the parameters; accepted: guess and lapse "
        "rates above 0, or wider grids",
        run.told + 1, answer.correct ? "correct" : "wrong", answer.level));
  for (double& likely : posterior) likely /= sum;
  choose(design, run);
}

Belief belief_by_entropy(const AdaptiveDesign& all, const AdaptiveRun& run) {
  const EntropyDesign& design = on_grid(all);
  const std::span<const double> posterior = posterior_of(run);
  const auto most = std::ranges::max_element(posterior) - posterior.begin();
  const std::vector<double> mode = combination(design, static_cast<std::size_t>(most));
  Belief belief{.entropy = entropy_of(posterior), .expected_entropy = run.memory[kExpectedEntropy]};
  std::size_t below = posterior.size();  // combinations for each value of the parameter
  for (std::size_t i = 0; i < design.parameters.size(); ++i) {
    const std::vector<double>& values = design.parameters[i].values;
    below /= values.size();
    double mean = 0.0, variance = 0.0;
    for (std::size_t j = 0; j < posterior.size(); ++j)
      mean += posterior[j] * values[j / below % values.size()];
    for (std::size_t j = 0; j < posterior.size(); ++j) {
      const double distance = values[j / below % values.size()] - mean;
      variance += posterior[j] * distance * distance;
    }
    belief.parameters.push_back(
        {.name = design.parameters[i].name, .mean = mean, .mode = mode[i], .sd = std::sqrt(variance)});
  }
  return belief;
}

}  // namespace palpate::trials
