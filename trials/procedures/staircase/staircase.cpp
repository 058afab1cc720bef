#include "trials/procedures/staircase/staircase.hpp"

#include <algorithm>
#include <array>

#include "trials/adaptive/level_steps.hpp"
#include "trials/adaptive/stop_keys.hpp"

namespace palpate::trials {
namespace staircase {
namespace {

struct Design : AdaptiveDesign {
  LevelSteps levels{};
  std::vector<double> sizes{};  // of steps: the first until the first reversal, and so on; the last stays
  int up = 1, down = 2;         // answers in a row
  bool initial_one_up_one_down = true;
};

// Beside the level and its direction.
enum : std::size_t {
  kCorrect = kStepMemorySize,
  kWrong,
  kMemorySize
};  // answers in a row since the last step

constexpr double kMostInARow = 100;

constexpr std::array kKeys{
    kStartKey,
    base::Key{.name = "steps",
              .takes = kLevels,
              .example = "[\"1.0 MPa\", \"0.5 MPa\"]",
              .meaning = "Step sizes above 0. Each reversal moves on to the next, from the very step that it "
                         "brings; the last stays."},
    kStepTypeKey,
    base::Key{.name = "up",
              .takes = base::takes_whole(1, kMostInARow),
              .fallback = "1",
              .meaning = "After so many wrong answers in a row the level rises."},
    base::Key{.name = "down",
              .takes = base::takes_whole(1, kMostInARow),
              .fallback = "2",
              .meaning = "After so many correct answers in a row the level falls."},
    base::Key{.name = "initial_one_up_one_down",
              .takes = base::kBoolean,
              .fallback = "true",
              .meaning = "Whether every answer is a step until the first reversal."},
    kMinKey,
    kMaxKey,
    kStopKey,
};

std::unique_ptr<const AdaptiveDesign> read(LevelReader& procedure) {
  auto design = std::make_unique<Design>();
  design->levels = read_level_steps(procedure);
  design->sizes = read_steps(procedure, "steps", design->levels.type);
  design->up = static_cast<int>(procedure.table().whole("up"));
  design->down = static_cast<int>(procedure.table().whole("down"));
  design->initial_one_up_one_down = procedure.table().boolean("initial_one_up_one_down");
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

void tell(const AdaptiveDesign& all, AdaptiveRun& run, const AdaptiveAnswer& answer) {
  const Design& design = own(all);
  run.memory[kCorrect] = answer.correct ? run.memory[kCorrect] + 1.0 : 0.0;
  run.memory[kWrong] = answer.correct ? 0.0 : run.memory[kWrong] + 1.0;
  const bool initial = design.initial_one_up_one_down && run.reversals.empty();
  const bool falls = run.memory[kCorrect] >= (initial ? 1 : design.down);
  const bool rises = run.memory[kWrong] >= (initial ? 1 : design.up);
  if (!falls && !rises) return;
  run.memory[kCorrect] = run.memory[kWrong] = 0.0;
  const double direction = falls ? -1.0 : 1.0;
  turn(run, answer, direction);
  const double size = design.sizes[std::min(run.reversals.size(), design.sizes.size() - 1)];
  run.memory[kAtLevel] = stepped(design.levels, run.memory[kAtLevel], direction * size);
}

std::optional<double> next(const AdaptiveDesign&, const AdaptiveRun& run) {
  return run.memory[kAtLevel];
}

std::optional<double> mean_of_reversals(const AdaptiveDesign& design, const AdaptiveRun& run) {
  return mean_of_levels(own(design).levels.type, run.reversals);
}

}  // namespace
}  // namespace staircase

constinit const AdaptiveProcedure kStaircase{
    .name = "staircase",
    .meaning = "so many correct answers in a row lower the level, so many wrong ones raise it",
    .keys = staircase::kKeys,
    .read = staircase::read,
    .begin = staircase::begin,
    .next = staircase::next,
    .tell = staircase::tell,
    .mean_of_reversals = staircase::mean_of_reversals};

}  // namespace palpate::trials
