#include "trials/observer/simulate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <future>
#include <limits>
#include <map>
#include <stdexcept>
#include <thread>

#include "base/clock/utc.hpp"
#include "trials/study/examinee_code.hpp"
#include "trials/study/verify.hpp"

namespace palpate::trials {
namespace {

constexpr int kMostAttempts = 100;  // of one interval, before the observer is given up

/// One who sits, and what was worked out for the trials that are drawn.
struct PlayedSitting {
  Session session;
  std::future<std::vector<SimulatedTrial>> played;
};

std::string purpose(const SessionRow& sitting, const DrawnTrial& drawn, std::string_view what) {
  return fmt::format("{} of {}, sitting {}, trial {}, draw {}", what, sitting.facts.examinee, sitting.number,
                     drawn.trial.number, drawn.draw);
}

/// Without a seed a person is drawn from the study's own random identity, so as to be the same person when
/// the sitting is resumed.
Seed person_seed(const StudyFile& study, const SimulationPlan& plan) {
  return plan.seed ? plan.seed : std::stoull(study.study().uuid.substr(0, 16), nullptr, 16);
}

std::vector<SimulatedTrial> play_all(const Protocol& protocol, const Stimuli& stimuli,
                                     const ObserverParameters& parameters, Seed seed_of_person,
                                     const SessionRow& sitting, const std::vector<DrawnTrial>& pending) {
  Generator generator = make_generator(seed_of_person, person_purpose(sitting.facts.examinee));
  const Observer observer = draw_observer(parameters, generator);
  std::vector<SimulatedTrial> played;
  played.reserve(pending.size());
  for (const DrawnTrial& drawn : pending) played.push_back(play(protocol, stimuli, observer, sitting, drawn));
  return played;
}

/// Puts what was played through the session, as the browser does with a person. Returns false when stopped.
bool hand_in(Session& session, std::vector<SimulatedTrial> played, const std::function<bool()>& answered) {
  for (SimulatedTrial& trial : played) {
    for (IntervalRecord& record : trial.presentations) {
      session.begin_interval();
      record.onset_utc = base::utc_now();
      session.end_interval(record);
    }
    session.answer(trial.response, std::nullopt, base::utc_now());
    if (!answered()) return false;
  }
  return true;
}

/// Puts a sitting through to its end; trials that its answers bring about are played as they are drawn.
template <class Play>
bool hand_in_all(PlayedSitting& sitting, const Play& play_drawn, const std::function<bool()>& answered) {
  Session& session = sitting.session;
  for (auto played = sitting.played.get();; played = play_drawn(session.row(), session.pending())) {
    if (!hand_in(session, std::move(played), answered)) return false;
    if (session.phase() == Phase::Finished) return true;
  }
}

/// Whose sittings are to be run: all who have not finished.
std::vector<int> unfinished(const std::vector<SessionRow>& sessions, const SimulationPlan& plan,
                            SimulationReport& report) {
  std::map<std::string, bool> finished;
  for (const SessionRow& session : sessions)
    if (session.facts.run_mode == RunMode::Simulated)
      finished[session.facts.examinee] |= session.ended_utc.has_value();
  std::vector<int> numbers;
  for (int number = 1; number <= plan.examinees; ++number) {
    const auto found = finished.find(simulated_code(number));
    if (found != finished.end() && found->second) {
      ++report.finished_before;
      continue;
    }
    ++(found == finished.end() ? report.added : report.resumed);
    numbers.push_back(number);
  }
  return numbers;
}

/// Simulated examinees of one study are all drawn from one population, with one seed.
void check_same_population(const std::vector<SessionRow>& sessions, const SimulationPlan& plan) {
  for (const SessionRow& session : sessions) {
    if (session.facts.run_mode != RunMode::Simulated) continue;
    if (session.facts.seed != plan.seed)
      throw std::invalid_argument(fmt::format(
          "--seed: the study's simulated examinees were run {}; accepted: the same again, or another study "
          "file",
          session.facts.seed ? fmt::format("with --seed {}", *session.facts.seed) : "without a seed"));
    if (session.facts.observer != to_json(plan.observer))
      throw std::invalid_argument(
          "--observer: the study's simulated examinees have other parameters; accepted: the same observer, "
          "or another study file");
  }
}

}  // namespace

void check_observer(const Protocol& protocol, const ObserverParameters& observer) {
  if (!protocol.answer)
    throw std::invalid_argument(fmt::format(
        "{}: task.answer: is missing, and the conditions do not tell which of them feels stiffer, "
        "which is all that a simulated examinee perceives; accepted: {}",
        protocol.file.string(), base::accepted_words(kAnswerWords)));
  if (observer.depth.mean < protocol.exploration.min_depth)
    throw std::invalid_argument(
        fmt::format("observer {}: press.depth is {:g} mm, but the protocol wants presses of {:g} mm and more",
                    observer.name, 1e3 * observer.depth.mean, 1e3 * protocol.exploration.min_depth));
  if (protocol.exploration.least_presses > 1)
    throw std::invalid_argument(
        fmt::format("observer {}: presses once in an interval, but the protocol wants {} presses",
                    observer.name, protocol.exploration.least_presses));
  if (protocol.exploration.max_time < kObserverCycles / kObserverRate)
    throw std::invalid_argument(fmt::format("observer {}: presses for {:g} s, but the protocol gives {:g} s",
                                            observer.name, kObserverCycles / kObserverRate,
                                            protocol.exploration.max_time));
}

SimulatedTrial play(const Protocol& protocol, const Stimuli& stimuli, const Observer& observer,
                    const SessionRow& sitting, const DrawnTrial& drawn) {
  Generator hand = make_generator(sitting.facts.seed, purpose(sitting, drawn, "hand"));
  Generator mind = make_generator(sitting.facts.seed, purpose(sitting, drawn, "mind"));
  SimulatedTrial trial;
  std::vector<std::optional<double>> percepts;
  for (const std::size_t condition : drawn.trial.interval_condition) {
    const sim::Model& model = *stimuli.at(stimulus_index(protocol, drawn.trial.cell, condition));
    sim::Simulation simulation(model);
    for (int attempt = 1;; ++attempt) {
      const auto path = plan_press(observer, model.probes.front().direction, hand);
      trial.presentations.push_back(drive(model, simulation, path, observer.parameters->device));
      if (judge(summarise(trial.presentations.back().trace), protocol.exploration) == Verdict::Enough) break;
      if (attempt == kMostAttempts)
        throw std::invalid_argument(fmt::format(
            "examinee {}: no press of {} went {:g} mm deep with contact; accepted: a protocol and an "
            "observer that fit each other",
            sitting.facts.examinee, kMostAttempts, 1e3 * protocol.exploration.min_depth));
    }
    percepts.push_back(perceive(trial.presentations.back().trace, observer, mind));
  }
  trial.response = protocol.task->decide(protocol, percepts, observer, mind);
  return trial;
}

std::string person_purpose(std::string_view examinee) {
  return fmt::format("person {}", examinee);
}

std::string simulated_code(int number) {
  return fmt::format("S{:02}", number);
}

SessionFacts simulated_facts(const SimulationPlan& plan, int number) {
  SessionFacts facts{.examinee = simulated_code(number), .run_mode = RunMode::Simulated};
  facts.software_version = plan.software_version;
  facts.machine = plan.machine;
  facts.device = "simulated observer";
  facts.force_scale = plan.observer.device.force_scale;
  facts.seed = plan.seed;
  facts.observer = to_json(plan.observer);
  return facts;
}

void check_simulation(const std::filesystem::path& path, const Protocol& protocol,
                      const SimulationPlan& plan) {
  check_observer(protocol, plan.observer);
  check_study(path, protocol);
  if (!std::filesystem::exists(path)) return;
  require_whole(path);
  const std::vector<SessionRow> sessions = read_study(path).sessions();
  check_same_population(sessions, plan);
  std::vector<std::string> known;
  known.reserve(sessions.size());
  for (const SessionRow& session : sessions) known.push_back(session.facts.examinee);
  for (int number = 1; number <= plan.examinees; ++number) {
    const std::string code = simulated_code(number);
    check_not_near(code, known);
    for (const SessionRow& session : sessions) check_not_shared(session, code, RunMode::Simulated);
  }
}

void check_clamping(const Protocol& protocol, const Stimuli& stimuli, const ObserverParameters& observer) {
  const ForceOutput& device = observer.device;
  for (std::size_t cell = 0; cell < protocol.cells.size(); ++cell) {
    double weakest = std::numeric_limits<double>::infinity();
    for (const std::size_t condition : protocol.presented) {
      const sim::Model& model = *stimuli.at(stimulus_index(protocol, cell, condition));
      sim::Simulation simulation(model);
      const std::vector<sim::Vec3> pressed{observer.depth.mean * model.probes.front().direction};
      const IntervalRecord record = drive(model, simulation, pressed, {.force_scale = device.force_scale});
      weakest = std::min(weakest, summarise(record.trace).peak_force);
    }
    if (weakest > device.max_force)
      throw std::invalid_argument(fmt::format(
          "observer {}: pressed {:g} mm deep with {}, both conditions give {:.3g} N and more, and the device "
          "cuts them both to {:g} N; accepted: a device.force_scale that keeps them apart",
          observer.name, 1e3 * observer.depth.mean, protocol.cells[cell].name, weakest, device.max_force));
  }
}

SimulationReport simulate(StudyFile& study, const Protocol& protocol, const Stimuli& stimuli,
                          const SimulationPlan& plan, const Progress& progress) {
  check_observer(protocol, plan.observer);
  study.lock_for_sessions();
  check_same_population(study.sessions(), plan);
  SimulationReport report;
  const std::vector<int> numbers = unfinished(study.sessions(), plan, report);
  int total = static_cast<int>(numbers.size()) * trials_per_session(protocol);

  const auto play_drawn = [&, person = person_seed(study, plan)](const SessionRow& sitting,
                                                                 const std::vector<DrawnTrial>& pending) {
    return play_all(protocol, stimuli, plan.observer, person, sitting, pending);
  };

  // Examinees are played side by side, and handed in one after the other: the file's order never depends on
  // threads.
  const std::size_t side_by_side = std::max(1U, std::thread::hardware_concurrency());
  for (std::size_t first = 0; first < numbers.size(); first += side_by_side) {
    std::vector<PlayedSitting> sittings;
    for (std::size_t i = first; i < std::min(first + side_by_side, numbers.size()); ++i) {
      Session session = start_session(study, protocol, simulated_facts(plan, numbers[i]));
      total -= session.answered();
      auto played = std::async(std::launch::async, play_drawn, session.row(), session.pending());
      sittings.push_back({std::move(session), std::move(played)});
    }
    for (PlayedSitting& sitting : sittings) {
      const bool went_on =
          hand_in_all(sitting, play_drawn, [&] { return progress(++report.answers, total); });
      if (went_on) continue;
      report.interrupted = report.answers < total;
      return report;
    }
  }
  return report;
}

}  // namespace palpate::trials
