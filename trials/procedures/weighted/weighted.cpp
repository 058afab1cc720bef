#include "trials/procedures/weighted/weighted.hpp"

#include <array>

#include "trials/adaptive/level_steps.hpp"
#include "trials/adaptive/stop_keys.hpp"

namespace palpate::trials {
namespace weighted {
namespace {

struct Design : AdaptiveDesign {
  LevelSteps levels{};
  double step_up = 0.0, step_down = 0.0;  // > 0
};

constexpr std::array kKeys{
    kStartKey,
    base::Key{.name = "step_up",
              .takes = kStepSize,
              .example = "\"1.5 MPa\"",
              .meaning = "How far a wrong answer raises the level: above 0."},
    base::Key{.name = "step_down",
              .takes = kStepSize,
              .example = "\"0.5 MPa\"",
              .meaning = "How far a correct answer lowers the level: above 0."},
    kStepTypeKey,
    kMinKey,
    kMaxKey,
    kStopKey,
};

std::unique_ptr<const AdaptiveDesign> read(LevelReader& procedure) {
  auto design = std::make_unique<Design>();
  design->levels = read_level_steps(procedure);
  design->step_up = read_step(procedure, "step_up", design->levels.type);
  design->step_down = read_step(procedure, "step_down", design->levels.type);
  design->stop = read_stop(procedure, true);
  return design;
}

const Design& own(const AdaptiveDesign& design) {
  return static_cast<const Design&>(design);
}

void begin(const AdaptiveDesign& design, AdaptiveRun& run) {
  run.memory.assign(kStepMemorySize, 0.0);
  run.memory[kAtLevel] = own(design).levels.start;
}

void tell(const AdaptiveDesign& all, AdaptiveRun& run, const AdaptiveAnswer& answer) {
  const Design& design = own(all);
  turn(run, answer, answer.correct ? -1.0 : 1.0);
  run.memory[kAtLevel] =
      stepped(design.levels, run.memory[kAtLevel], answer.correct ? -design.step_down : design.step_up);
}

std::optional<double> next(const AdaptiveDesign&, const AdaptiveRun& run) {
  return run.memory[kAtLevel];
}

std::optional<double> mean_of_reversals(const AdaptiveDesign& design, const AdaptiveRun& run) {
  return mean_of_levels(own(design).levels.type, run.reversals);
}

}  // namespace
}  // namespace weighted

constinit const AdaptiveProcedure kWeighted{
    .name = "weighted",
    .meaning = "every correct answer lowers the level by one step size, every wrong one raises it by another",
    .keys = weighted::kKeys,
    .read = weighted::read,
    .begin = weighted::begin,
    .next = weighted::next,
    .tell = weighted::tell,
    .mean_of_reversals = weighted::mean_of_reversals};

}  // namespace palpate::trials
