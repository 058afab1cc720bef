#include "trials/procedures/psi/psi.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "trials/adaptive/entropy_choice.hpp"
#include "trials/adaptive/psychometric.hpp"
#include "trials/adaptive/stop_keys.hpp"

namespace palpate::trials {
namespace psi {
namespace {

enum class Task { TwoIntervals, YesNo };
constexpr base::EnumWords<Task, 2> kTaskWords{
    {{Task::TwoIntervals, "2AFC", "d' = (level / alpha)^beta, and Phi(d' / sqrt 2) answers are correct"},
     {Task::YesNo, "yes/no", "Phi((level - alpha) / beta) answers are yes"}}};

constexpr std::array kKeys{
    base::Key{.name = "levels",
              .takes = kLevels,
              .example = "[\"0.5 MPa\", \"1 MPa\", \"2 MPa\"]",
              .meaning = "The levels to choose from, rising."},
    base::Key{.name = "alpha",
              .takes = kLevels,
              .example = "[\"0.5 MPa\", \"1 MPa\", \"2 MPa\"]",
              .meaning = "The values that the threshold may have, rising."},
    base::Key{.name = "beta",
              .takes = kNumbers,
              .example = "[0.5, 1, 2]",
              .meaning =
                  "The values that the slope may have, rising and above 0: the exponent of d' with 2AFC, the "
                  "spread in units of the level with yes/no."},
    base::Key{.name = "lapse",
              .takes = base::takes_number({.least = 0.0, .most = 0.5}),
              .fallback = "0.04",
              .meaning = "Share of answers that are guessed whatever the level."},
    base::Key{.name = "task",
              .takes = base::takes_word(base::words_of<kTaskWords>),
              .fallback = "\"2AFC\"",
              .meaning = "What an answer is, and with it the psychometric function."},
    kStopAfterTrialsKey,
};

std::vector<double> alike(std::size_t count) {
  return std::vector<double>(count, 1.0 / static_cast<double>(count));
}

/// The share of correct or yes answers of one who is attentive.
double attentive(Task task, double level, double alpha, double beta) {
  if (task == Task::YesNo)
    return share_correct(PsychometricFunction::Normal, level, {.threshold = alpha, .slope = 1.0 / beta});
  const double sensitivity = std::pow(level / alpha, beta);
  return share_correct(PsychometricFunction::Normal, sensitivity, {.slope = std::sqrt(0.5)});
}

std::unique_ptr<const AdaptiveDesign> read(LevelReader& procedure) {
  auto design = std::make_unique<EntropyDesign>();
  const Task task = procedure.table().word("task", kTaskWords);
  const double lapse = procedure.table().number("lapse");
  design->levels = procedure.levels("levels");
  const std::vector<double> alpha = procedure.levels("alpha"), beta = procedure.numbers("beta");
  refuse_unless_rising(procedure, "levels", design->levels);
  refuse_unless_rising(procedure, "alpha", alpha);
  refuse_unless_rising(procedure, "beta", beta);
  if (beta.front() <= 0.0)
    procedure.refuse("beta", fmt::format("found {:g}, accepted: values above 0", beta.front()));
  if (task == Task::TwoIntervals) {
    if (design->levels.front() < 0.0)
      procedure.refuse("levels", fmt::format("found {}, accepted with 2AFC: levels of 0 or above",
                                             procedure.in_words(design->levels.front())));
    if (alpha.front() <= 0.0)
      procedure.refuse("alpha", fmt::format("found {}, accepted with 2AFC: levels above 0",
                                            procedure.in_words(alpha.front())));
  }
  design->parameters = {{"alpha", alpha, alike(alpha.size())}, {"beta", beta, alike(beta.size())}};
  refuse_too_many(procedure, "alpha", *design);
  design->stop = read_stop(procedure, false);
  prepare(*design, [&](double level, std::span<const double> values) {
    return lapse / 2.0 + (1.0 - lapse) * attentive(task, level, values[0], values[1]);
  });
  return design;
}

}  // namespace
}  // namespace psi

constinit const AdaptiveProcedure kPsi{
    .name = "psi",
    .meaning = "the level after whose answer threshold and slope are expected to be least uncertain (psi)",
    .keys = psi::kKeys,
    .read = psi::read,
    .begin = begin_by_entropy,
    .next = next_by_entropy,
    .tell = tell_by_entropy,
    .belief = belief_by_entropy};

}  // namespace palpate::trials
