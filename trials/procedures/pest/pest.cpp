#include "trials/procedures/pest/pest.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "trials/adaptive/level_steps.hpp"
#include "trials/adaptive/stop_keys.hpp"

namespace palpate::trials {
namespace pest {
namespace {

struct Design : AdaptiveDesign {
  LevelSteps levels{};
  double first_step = 0.0, min_step = 0.0, max_step = 0.0;
  double target = 0.75;  // share correct
  double wald = 1.0;     // W: answers that the count of correct ones may be off what the target expects
};

// Beside the level and its direction.
enum : std::size_t {
  kStep = kStepMemorySize,  // size of the last one
  kInDirection,             // steps since the last reversal, that of the reversal included
  kDoubled,                 // 1: the last step was doubled
  kDoubledBefore,           // 1: so was the step before the last reversal
  kAsked,                   // answers at this level
  kCorrect,                 // of these
  kEnded,                   // 1: a step below min_step was called for, and the level is where it leads
  kMemorySize
};

constexpr double kRounding = 1e-9;  // answers: target times count is rounded

constexpr std::array kKeys{
    kStartKey,
    base::Key{.name = "first_step",
              .takes = kStepSize,
              .example = "\"1 MPa\"",
              .meaning = "The size of the first step."},
    base::Key{
        .name = "min_step",
        .takes = kStepSize,
        .example = "\"0.1 MPa\"",
        .meaning =
            "The run ends when a smaller step is called for; the level where it leads is the estimate."},
    base::Key{
        .name = "max_step", .takes = kStepSize, .example = "\"2 MPa\"", .meaning = "No step is larger."},
    base::Key{.name = "target",
              .takes = base::takes_number({.least = 0.0, .most = 1.0, .open = true}),
              .fallback = "0.75",
              .meaning = "The share correct that is sought."},
    base::Key{.name = "wald",
              .takes = base::takes_number(base::kPositive),
              .fallback = "1.0",
              .meaning =
                  "W: the level changes when the correct answers at it are so many more or fewer than the "
                  "target expects, or further off."},
    kStepTypeKey,
    kMinKey,
    kMaxKey,
    kStopKey,
};

std::unique_ptr<const AdaptiveDesign> read(LevelReader& procedure) {
  auto design = std::make_unique<Design>();
  design->levels = read_level_steps(procedure);
  design->first_step = read_step(procedure, "first_step", design->levels.type);
  design->min_step = read_step(procedure, "min_step", design->levels.type);
  design->max_step = read_step(procedure, "max_step", design->levels.type);
  if (design->first_step < design->min_step || design->first_step > design->max_step)
    procedure.refuse("first_step", fmt::format("found {:g}, accepted: from min_step {:g} to max_step {:g}",
                                               design->first_step, design->min_step, design->max_step));
  design->target = procedure.table().number("target");
  design->wald = procedure.table().number("wald");
  design->stop = read_stop(procedure, true);
  return design;
}

const Design& own(const AdaptiveDesign& design) {
  return static_cast<const Design&>(design);
}

void begin(const AdaptiveDesign& design, AdaptiveRun& run) {
  run.memory.assign(kMemorySize, 0.0);
  run.memory[kAtLevel] = own(design).levels.start;
}

/// -1 where the correct answers at this level are too many for the target, 1 where they are too few, else 0.
double called_direction(const Design& design, const AdaptiveRun& run) {
  const double excess = run.memory[kCorrect] - design.target * run.memory[kAsked];
  if (excess >= design.wald - kRounding) return -1.0;
  return excess <= -design.wald + kRounding ? 1.0 : 0.0;
}

/// The rules for the size of a step, by which the memory of steps goes on.
double step_size(const Design& design, AdaptiveRun& run, bool turned) {
  std::vector<double>& memory = run.memory;
  bool doubled = false;
  if (memory[kStep] == 0.0) {
    memory[kStep] = design.first_step;
    memory[kInDirection] = 1.0;
    return memory[kStep];
  }
  if (turned) {
    memory[kDoubledBefore] = memory[kDoubled];
    memory[kInDirection] = 1.0;
    memory[kStep] /= 2.0;
  } else {
    memory[kInDirection] += 1.0;
    doubled = memory[kInDirection] >= 4.0 || (memory[kInDirection] == 3.0 && memory[kDoubledBefore] == 0.0);
    if (doubled) memory[kStep] = std::min(2.0 * memory[kStep], design.max_step);
  }
  memory[kDoubled] = doubled ? 1.0 : 0.0;
  return memory[kStep];
}

void tell(const AdaptiveDesign& all, AdaptiveRun& run, const AdaptiveAnswer& answer) {
  const Design& design = own(all);
  run.memory[kAsked] += 1.0;
  if (answer.correct) run.memory[kCorrect] += 1.0;
  const double direction = called_direction(design, run);
  if (direction == 0.0) return;
  run.memory[kAsked] = run.memory[kCorrect] = 0.0;
  const double size = step_size(design, run, turn(run, answer, direction));
  run.memory[kAtLevel] = stepped(design.levels, run.memory[kAtLevel], direction * size);
  if (size < design.min_step * (1.0 - kRounding)) run.memory[kEnded] = 1.0;
}

std::optional<double> next(const AdaptiveDesign&, const AdaptiveRun& run) {
  if (run.memory[kEnded] != 0.0) return std::nullopt;
  return run.memory[kAtLevel];
}

std::optional<double> mean_of_reversals(const AdaptiveDesign& design, const AdaptiveRun& run) {
  return mean_of_levels(own(design).levels.type, run.reversals);
}

std::optional<double> estimate(const AdaptiveDesign&, const AdaptiveRun& run) {
  if (run.memory[kEnded] == 0.0) return std::nullopt;
  return run.memory[kAtLevel];
}

}  // namespace
}  // namespace pest

constinit const AdaptiveProcedure kPest{
    .name = "pest",
    .meaning = "a level is asked until it is seen to be off the target; steps are halved and doubled (PEST)",
    .keys = pest::kKeys,
    .read = pest::read,
    .begin = pest::begin,
    .next = pest::next,
    .tell = pest::tell,
    .mean_of_reversals = pest::mean_of_reversals,
    .estimate = pest::estimate};

}  // namespace palpate::trials
