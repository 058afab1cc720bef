#include "trials/procedures/questplus/questplus.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "trials/adaptive/entropy_choice.hpp"
#include "trials/adaptive/psychometric.hpp"
#include "trials/adaptive/stop_keys.hpp"

namespace palpate::trials {
namespace questplus {
namespace {

enum : std::size_t { kThreshold, kSlope, kGuess, kLapse };  // EntropyDesign::parameters

constexpr std::array kKeys{
    base::Key{.name = "function",
              .takes = base::takes_word(base::words_of<kFunctionWords>),
              .example = "\"weibull_db\"",
              .meaning =
                  "How the share of correct answers grows with the level. Of quantities weibull_db takes 20 "
                  "log10; numbers are in dB already."},
    base::Key{.name = "levels",
              .takes = kLevels,
              .example = "[-40, -30, -20, -10, 0]",
              .meaning = "The levels to choose from, rising."},
    base::Key{.name = "parameters",
              .takes = base::takes_table("a table with threshold, slope, guess and lapse"),
              .meaning = "The values that each parameter may have, rising; one alone is known beforehand."},
    base::Key{.name = "prior",
              .takes = base::takes_table("a table of lists, such as { threshold = [1, 2, 1] }"),
              .absent = "all values of a parameter are as likely",
              .meaning = "How likely the values of a parameter are beforehand, a weight for each."},
    kStopAfterTrialsKey,
};

constexpr std::array kParameterKeys{
    base::Key{.name = "threshold", .takes = kLevels, .meaning = "Where the function stands, as a level."},
    base::Key{
        .name = "slope",
        .takes = kNumbers,
        .meaning = "How steep it is, above 0: per unit of the level, of weibull_db Weibull's exponent."},
    base::Key{.name = "guess", .takes = kNumbers, .meaning = "Share of correct answers far below threshold."},
    base::Key{.name = "lapse", .takes = kNumbers, .meaning = "Share of wrong answers far above it."},
};

constexpr std::array kPriorKeys{
    base::Key{.name = "threshold", .takes = kNumbers, .absent = "all as likely"},
    base::Key{.name = "slope", .takes = kNumbers, .absent = "all as likely"},
    base::Key{.name = "guess", .takes = kNumbers, .absent = "all as likely"},
    base::Key{.name = "lapse", .takes = kNumbers, .absent = "all as likely"},
};

void read_parameters(LevelReader& procedure, EntropyDesign& design) {
  base::TomlReader table = procedure.table().table("parameters", kParameterKeys);
  LevelReader reader = procedure.within(table);
  for (const base::Key& key : kParameterKeys) {
    std::vector<double> values = key.name == "threshold" ? reader.levels(key.name) : reader.numbers(key.name);
    refuse_unless_rising(reader, key.name, values);
    design.parameters.push_back({.name = key.name, .values = std::move(values)});
  }
  table.refuse_unknown();
  if (const double slope = design.parameters[kSlope].values.front(); slope <= 0.0)
    reader.refuse("slope", fmt::format("found {:g}, accepted: slopes above 0", slope));
  for (const std::size_t rate : {kGuess, kLapse}) {
    const GridParameter& parameter = design.parameters[rate];
    if (parameter.values.front() < 0.0)
      reader.refuse(parameter.name,
                    fmt::format("found {:g}, accepted: shares of 0 or above", parameter.values.front()));
  }
  const double guess = design.parameters[kGuess].values.back(),
               lapse = design.parameters[kLapse].values.back();
  if (guess + lapse >= 1.0)
    reader.refuse("lapse", fmt::format("found {:g} beside a guess rate of {:g}, accepted: together below 1",
                                       lapse, guess));
}

void read_prior(LevelReader& reader, GridParameter& parameter) {
  std::vector<double> weights = reader.numbers(parameter.name);
  if (weights.size() != parameter.values.size())
    reader.refuse(parameter.name, fmt::format("has {} weights for {} values; accepted: one for each",
                                              weights.size(), parameter.values.size()));
  for (const double weight : weights)
    if (weight < 0.0)
      reader.refuse(parameter.name, fmt::format("holds {:g}, accepted: weights of 0 or above", weight));
  const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
  if (!(sum > 0.0)) reader.refuse(parameter.name, "has no weight above 0; accepted: at least one");
  for (std::size_t i = 0; i < weights.size(); ++i) parameter.prior.at(i) = weights[i] / sum;
}

void read_priors(LevelReader& procedure, EntropyDesign& design) {
  for (GridParameter& parameter : design.parameters)
    parameter.prior.assign(parameter.values.size(), 1.0 / static_cast<double>(parameter.values.size()));
  if (!procedure.has("prior")) return;
  base::TomlReader table = procedure.table().table("prior", kPriorKeys);
  LevelReader reader = procedure.within(table);
  for (GridParameter& parameter : design.parameters)
    if (table.has(parameter.name)) read_prior(reader, parameter);
  table.refuse_unknown();
}

void refuse_unless_positive(const LevelReader& procedure, const EntropyDesign& design) {
  if (design.levels.front() <= 0.0)
    procedure.refuse("levels", fmt::format("found {}, accepted with weibull_db: quantities above 0",
                                           procedure.in_words(design.levels.front())));
  if (const double threshold = design.parameters[kThreshold].values.front(); threshold <= 0.0)
    procedure.refuse("parameters",
                     fmt::format("found the threshold {}, accepted with weibull_db: quantities above 0",
                                 procedure.in_words(threshold)));
}

std::unique_ptr<const AdaptiveDesign> read(LevelReader& procedure) {
  auto design = std::make_unique<EntropyDesign>();
  const PsychometricFunction function = procedure.table().word("function", kFunctionWords);
  design->levels = procedure.levels("levels");
  refuse_unless_rising(procedure, "levels", design->levels);
  read_parameters(procedure, *design);
  read_priors(procedure, *design);
  refuse_too_many(procedure, "parameters", *design);
  const bool in_decibels = function == PsychometricFunction::WeibullDb && procedure.scale().unit.has_value();
  if (in_decibels) refuse_unless_positive(procedure, *design);
  design->stop = read_stop(procedure, false);
  prepare(*design, [&](double level, std::span<const double> values) {
    const auto x = [&](double value) { return in_decibels ? 20.0 * std::log10(value) : value; };
    return share_correct(function, x(level),
                         {.threshold = x(values[kThreshold]),
                          .slope = values[kSlope],
                          .guess = values[kGuess],
                          .lapse = values[kLapse]});
  });
  return design;
}

}  // namespace
}  // namespace questplus

constinit const AdaptiveProcedure kQuestPlus{
    .name = "questplus",
    .meaning = "the level after whose answer the parameters are expected to be least uncertain (QUEST+)",
    .keys = questplus::kKeys,
    .read = questplus::read,
    .begin = begin_by_entropy,
    .next = next_by_entropy,
    .tell = tell_by_entropy,
    .belief = belief_by_entropy};

}  // namespace palpate::trials
