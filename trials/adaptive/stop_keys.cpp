#include "trials/adaptive/stop_keys.hpp"

namespace palpate::trials {
namespace {

constexpr double kMostTrials = 10000;  // of a run: more is a slip of the keyboard

constexpr std::array kStopKeys{
    base::Key{.name = "trials",
              .takes = base::takes_whole(1, kMostTrials),
              .absent = "no end by trials",
              .meaning = "After so many answers."},
    base::Key{.name = "reversals",
              .takes = base::takes_whole(1, kMostTrials),
              .absent = "no end by reversals",
              .meaning = "After so many reversals."},
};

}  // namespace

StopRule read_stop(LevelReader& procedure, bool by_reversals) {
  StopRule stop;
  if (!procedure.has("stop")) return stop;
  base::TomlReader table = procedure.table().table("stop", std::span(kStopKeys).first(by_reversals ? 2 : 1));
  if (table.has("trials")) stop.trials = static_cast<int>(table.whole("trials"));
  if (by_reversals && table.has("reversals")) stop.reversals = static_cast<int>(table.whole("reversals"));
  table.refuse_unknown();
  if (!stop.trials && !stop.reversals)
    procedure.refuse("stop", by_reversals ? "is empty; accepted: reversals, trials or both"
                                          : "is empty; accepted: trials");
  return stop;
}

}  // namespace palpate::trials
