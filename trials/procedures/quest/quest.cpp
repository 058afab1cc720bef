#include "trials/procedures/quest/quest.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "trials/adaptive/level_reader.hpp"
#include "trials/adaptive/psychometric.hpp"
#include "trials/adaptive/stop_keys.hpp"

namespace palpate::trials {
namespace quest {
namespace {

enum class Next { Quantile, Mean, Mode };
constexpr base::EnumWords<Next, 3> kNextWords{
    {{Next::Quantile, "quantile", "the quantile that tells most, by Pelli 1987"},
     {Next::Mean, "mean", "the mean, by King-Smith et al. 1994"},
     {Next::Mode, "mode", "the most likely threshold, by Watson and Pelli 1983"}}};

/// On x: the level where it is a plain number, log10 of it where it is a quantity.
struct Design : AdaptiveDesign {
  bool log_of_level = false;
  double guess = 0.0, guess_sd = 1.0, target = 0.5;
  double beta = 3.5, delta = 0.01, gamma = 0.5;
  Next next = Next::Quantile;
  double offset = 0.0;          // of the Weibull function: F is at the target where x is the threshold
  double quantile = 0.5;        // that is asked with Next::Quantile
  double grain = 0.01;          // of the grid
  std::vector<double> grid{};   // thresholds, less the guess, rising
  std::vector<double> prior{};  // of each, sums to 1
};

constexpr double kMostDecades = 100.0;  // of quantities: levels stay numbers
constexpr double kMostGrid = 100'000;   // thresholds: the time of a trial is in proportion

constexpr std::array kKeys{
    base::Key{
        .name = "guess_level",
        .takes = kLevel,
        .example = "\"2.0 MPa\"",
        .meaning = "Where the threshold is thought to be: the middle of the normal prior and of the grid."},
    base::Key{
        .name = "guess_sd",
        .takes = base::takes_number(base::kPositive),
        .example = "0.3",
        .meaning = "Standard deviation of the prior, on the scale of x. Rather too large than too small."},
    base::Key{.name = "target",
              .takes = base::takes_number({.least = 0.0, .most = 1.0, .open = true}),
              .fallback = "0.82",
              .meaning = "The share correct at which the level is called the threshold."},
    base::Key{.name = "beta",
              .takes = base::takes_number(base::kPositive),
              .fallback = "3.5",
              .meaning = "Slope of the Weibull function: its exponent, with x in log10."},
    base::Key{.name = "delta",
              .takes = base::takes_number({.least = 0.0, .most = 0.5}),
              .fallback = "0.01",
              .meaning = "Share of answers that are guessed whatever the level."},
    base::Key{.name = "gamma",
              .takes = base::takes_number({.least = 0.0, .most = 0.99}),
              .fallback = "0.5",
              .meaning = "Share of guesses that are correct: one over the number of choices."},
    base::Key{.name = "grain",
              .takes = base::takes_number(base::kPositive),
              .fallback = "0.01",
              .meaning = "Distance of the grid's thresholds, on the scale of x."},
    base::Key{.name = "range",
              .takes = base::takes_number(base::kPositive),
              .fallback = "5.0",
              .meaning = "From the lowest to the highest threshold of the grid, on the scale of x."},
    base::Key{.name = "next",
              .takes = base::takes_word(base::words_of<kNextWords>),
              .fallback = "\"quantile\"",
              .meaning = "Which figure of the threshold is the next level."},
    kStopAfterTrialsKey,
};

const Design& own(const AdaptiveDesign& design) {
  return static_cast<const Design&>(design);
}

/// The share correct at a distance above the threshold, without the offset.
double share_at(const Design& design, double x) {
  return design.delta * design.gamma +
         (1.0 - design.delta) * (1.0 - (1.0 - design.gamma) * std::exp(-std::pow(10.0, design.beta * x)));
}

double share_above_threshold(const Design& design, double distance) {
  return share_at(design, distance + design.offset);
}

/// The quantile that Psychtoolbox's QuestCreate asks (Pelli 1987): it follows from the ends of the function.
/// @param low, high  the share correct far below and far above threshold
double telling_quantile(double low, double high) {
  const auto bits = [](double p) { return p > 0.0 ? p * std::log(p) : 0.0; };
  const double entropy = bits(high) - bits(low) + bits(1.0 - high) - bits(1.0 - low);
  const double even = 1.0 / (1.0 + std::exp(entropy / (low - high)));
  return (even - low) / (high - low);
}

void read_shape(LevelReader& procedure, Design& design) {
  base::TomlReader& table = procedure.table();
  design.target = table.number("target");
  design.beta = table.number("beta");
  design.delta = table.number("delta");
  design.gamma = table.number("gamma");
  design.next = table.word("next", kNextWords);
  const double low = design.gamma, high = design.delta * design.gamma + 1.0 - design.delta;
  if (design.target <= low || design.target >= high)
    procedure.refuse(
        "target", fmt::format("found {:g}, accepted: a share above {:g} and below {:g}, which the function "
                              "passes",
                              design.target, low, high));
  // share_at(offset) = target, solved for the offset.
  const double missed = 1.0 - (design.target - design.delta * design.gamma) / (1.0 - design.delta);
  design.offset = std::log10(-std::log(missed / (1.0 - design.gamma))) / design.beta;
  design.quantile = telling_quantile(low, high);
}

void make_grid(LevelReader& procedure, Design& design, double range) {
  if (design.log_of_level && range > kMostDecades)
    procedure.refuse("range", fmt::format("found {:g}, accepted with quantities: up to {:g} decades", range,
                                          kMostDecades));
  const double half =
      std::ceil(range / design.grain / 2.0 - 1e-9);  // 5 / 0.01 / 2 is 250, however it is rounded
  if (2.0 * half + 1.0 > kMostGrid)
    procedure.refuse("grain", fmt::format("a grid of {:.0f} thresholds, accepted: up to {:.0f}",
                                          2.0 * half + 1.0, kMostGrid));
  const auto most = static_cast<int>(half);
  for (int step = -most; step <= most; ++step) design.grid.push_back(step * design.grain);
  for (const double x : design.grid)
    design.prior.push_back(std::exp(-0.5 * (x / design.guess_sd) * (x / design.guess_sd)));
  const double sum = std::accumulate(design.prior.begin(), design.prior.end(), 0.0);
  for (double& share : design.prior) share /= sum;
}

std::unique_ptr<const AdaptiveDesign> read(LevelReader& procedure) {
  auto design = std::make_unique<Design>();
  const double guess = procedure.level("guess_level");
  design->log_of_level = procedure.scale().unit.has_value();
  if (design->log_of_level && guess <= 0.0)
    procedure.refuse("guess_level",
                     fmt::format("found {}, accepted: a quantity above 0", procedure.in_words(guess)));
  design->guess = design->log_of_level ? std::log10(guess) : guess;
  design->guess_sd = procedure.table().number("guess_sd");
  design->grain = procedure.table().number("grain");
  read_shape(procedure, *design);
  make_grid(procedure, *design, procedure.table().number("range"));
  design->stop = read_stop(procedure, false);
  return design;
}

void begin(const AdaptiveDesign& design, AdaptiveRun& run) {
  run.memory = own(design).prior;
}

double as_level(const Design& design, double x) {
  return design.log_of_level ? std::pow(10.0, x) : x;
}

double mean_of(const Design& design, std::span<const double> posterior) {
  return design.guess + std::inner_product(posterior.begin(), posterior.end(), design.grid.begin(), 0.0);
}

double mode_of(const Design& design, std::span<const double> posterior) {
  return design.guess + design.grid[std::ranges::max_element(posterior) - posterior.begin()];
}

/// Between the grid's thresholds by a straight line of the cumulated shares.
double quantile_of(const Design& design, std::span<const double> posterior) {
  const double sought = design.quantile * std::accumulate(posterior.begin(), posterior.end(), 0.0);
  double below = posterior[0];
  if (sought <= below) return design.guess + design.grid[0];
  for (std::size_t i = 1; i < posterior.size(); ++i) {
    if (posterior[i] > 0.0 && below + posterior[i] >= sought)
      return design.guess + design.grid[i - 1] +
             (sought - below) / posterior[i] * (design.grid[i] - design.grid[i - 1]);
    below += posterior[i];
  }
  return design.guess + design.grid.back();
}

double next_x(const Design& design, const AdaptiveRun& run) {
  switch (design.next) {
    case Next::Quantile:
      return quantile_of(design, run.memory);
    case Next::Mean:
      return mean_of(design, run.memory);
    case Next::Mode:
      return mode_of(design, run.memory);
  }
  return design.guess;
}

/// The share correct of every threshold of the grid. The level counts as the nearest point of the grid, as in
/// Psychtoolbox's QuestUpdate.
std::vector<double> shares_at(const Design& design, double x) {
  const double shown = std::round((x - design.guess) / design.grain) * design.grain;
  std::vector<double> shares;
  shares.reserve(design.grid.size());
  for (const double threshold : design.grid)
    shares.push_back(share_above_threshold(design, shown - threshold));
  return shares;
}

std::optional<double> next(const AdaptiveDesign& design, const AdaptiveRun& run) {
  return as_level(own(design), next_x(own(design), run));
}

void tell(const AdaptiveDesign& all, AdaptiveRun& run, const AdaptiveAnswer& answer) {
  const Design& design = own(all);
  const double x = design.log_of_level ? std::log10(answer.level) : answer.level;
  const std::vector<double> shares = shares_at(design, x);
  double sum = 0.0;
  for (std::size_t i = 0; i < shares.size(); ++i)
    sum += run.memory[i] *= answer.correct ? shares[i] : 1.0 - shares[i];
  if (!(sum > 0.0))
    throw std::invalid_argument(fmt::format(
        "answer {}: {} at {:g} has no chance with any threshold of the grid; accepted: a delta above 0, or a "
        "wider range",
        run.told + 1, answer.correct ? "correct" : "wrong", answer.level));
  for (double& share : run.memory) share /= sum;
}

Belief belief(const AdaptiveDesign& all, const AdaptiveRun& run) {
  const Design& design = own(all);
  const double mean = mean_of(design, run.memory);
  double variance = 0.0, entropy = 0.0;
  for (std::size_t i = 0; i < run.memory.size(); ++i) {
    const double distance = design.guess + design.grid[i] - mean, share = run.memory[i];
    variance += share * distance * distance;
    if (share > 0.0) entropy -= share * std::log2(share);
  }
  double correct = 0.0, known = 0.0;
  const std::vector<double> shares = shares_at(design, next_x(design, run));
  for (std::size_t i = 0; i < shares.size(); ++i) {
    correct += run.memory[i] * shares[i];
    known += run.memory[i] * binary_entropy(shares[i]);
  }
  return {.parameters = {{.name = "threshold",
                          .mean = as_level(design, mean),
                          .mode = as_level(design, mode_of(design, run.memory)),
                          .sd = std::sqrt(variance)}},
          .entropy = entropy,
          .expected_entropy = entropy - (binary_entropy(correct) - known)};
}

}  // namespace
}  // namespace quest

constinit const AdaptiveProcedure kQuest{
    .name = "quest",
    .meaning = "the mean, the mode or a quantile of what is known of the threshold (QUEST)",
    .keys = quest::kKeys,
    .read = quest::read,
    .begin = quest::begin,
    .next = quest::next,
    .tell = quest::tell,
    .belief = quest::belief};

}  // namespace palpate::trials
