#pragma once

#include <functional>
#include <string>
#include <vector>

#include "trials/observer/observer.hpp"
#include "trials/protocol/stimuli.hpp"
#include "trials/session/session.hpp"

namespace palpate::trials {

/// A simulated examinee's answer to one trial, with everything that led to it.
struct SimulatedTrial {
  /// In order; an interval not explored enough is followed by itself again.
  std::vector<IntervalRecord> presentations{};
  int response = 0;
};

/// Plays one trial: each interval is pressed until it is explored enough, then the question is answered.
/// Depends on seed, examinee and the numbers of sitting, trial and draw, and of course on the models; not on
/// anybody else. Throws std::invalid_argument when the observer's hand cannot fulfil the exploration rule.
SimulatedTrial play(const Protocol& protocol, const Stimuli& stimuli, const Observer& observer,
                    const SessionRow& sitting, const DrawnTrial& drawn);

struct SimulationPlan {
  int examinees = 0;  // that the study file holds in the end: S01, S02, ...
  ObserverParameters observer{};
  Seed seed{};
  std::string software_version{};
  std::string machine{};
};

struct SimulationReport {
  int finished_before = 0, resumed = 0, added = 0;
  int answers = 0;           // given in this run
  bool interrupted = false;  // stopped on request; what was answered is kept
};

/// Called after every answer with the number of answers given and expected in this run; false stops.
using Progress = std::function<bool(int done, int total)>;

/// The code of simulated examinee `number` (from 1): S01.
std::string simulated_code(int number);

/// What a simulated person is drawn for: the purpose of its generator.
std::string person_purpose(std::string_view examinee);

/// Facts of a simulated sitting, for check_start().
SessionFacts simulated_facts(const SimulationPlan& plan, int number);

/// Runs simulated examinees until the study holds plan.examinees finished ones: those who had finished are
/// kept, one who was cut off goes on. No other program leads sessions meanwhile (std::runtime_error). Each
/// answer is on the disk before the next is asked for. The same seed gives the same answers, on any number of
/// threads.
SimulationReport simulate(StudyFile& study, const Protocol& protocol, const Stimuli& stimuli,
                          const SimulationPlan& plan, const Progress& progress);

/// Throws std::invalid_argument where the device would cut both conditions of a cell to one force.
void check_clamping(const Protocol& protocol, const Stimuli& stimuli, const ObserverParameters& observer);

/// Throws std::invalid_argument where the observer's hand cannot do what the protocol asks of an interval.
void check_observer(const Protocol& protocol, const ObserverParameters& observer);

/// Refuses what simulate() would refuse, and writes nothing.
void check_simulation(const std::filesystem::path& path, const Protocol& protocol,
                      const SimulationPlan& plan);

}  // namespace palpate::trials
