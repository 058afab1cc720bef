#pragma once

#include <cmath>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/cycle/simulation.hpp"
#include "trials/plan/random.hpp"
#include "trials/trace/trace.hpp"

namespace palpate::trials {

/// A quantity that differs between people and from press to press.
struct Variation {
  double mean = 0.0;
  double between = 0.0;  // standard deviation between examinees
  double within = 0.0;   // standard deviation between presses of one examinee
};

/// How the force of the scene becomes the force on the finger: scaled, then cut.
struct ForceOutput {
  double force_scale = 1.0;     // [-]
  double max_force = INFINITY;  // largest magnitude that the device gives [N]
};

/// What simulated examinees are like; read from a file such as protocols/observers/default.toml, which gives
/// the source of every figure.
struct ObserverParameters {
  std::string name{};
  std::string text{};  // of the file

  // How the hand presses.
  Variation depth{};           // deepest point that is aimed at [m]
  Variation duration{};        // of the way in [s]; the rest of the second the finger stays
  double tremor = 0.0;         // along the press, root mean square [m]
  double tremor_period = 0.1;  // [s]
  double drift = 0.0;          // sideways, root mean square in each direction [m]
  double drift_period = 1.0;   // [s]

  ForceOutput device{};

  // What is perceived.
  double force_noise = 0.0;     // of each sample, standard deviation [N]
  double position_noise = 0.0;  // of each sample, standard deviation [m]
  /// Relative difference of the perceived stiffness that a 2IFC question is answered correctly at in 75 % of
  /// the trials, apart from lapses, bias and the noise of samples.
  Variation weber_fraction{};  // within is 0

  // How the answer is given.
  double lapse_rate = 0.0;  // share of trials that are answered by a coin
  /// Towards the second interval, in standard deviations of the difference; within is 0.
  Variation interval_bias{};
};

/// Throws std::invalid_argument: file, line or key, what was found, what is accepted.
ObserverParameters load_observer(const std::filesystem::path& file);

/// The parameters as JSON, as a study file keeps them.
std::string to_json(const ObserverParameters& parameters);

/// One simulated person.
struct Observer {
  const ObserverParameters* parameters = nullptr;
  double depth = 0.0, duration = 0.0;  // this person's means
  double weber_fraction = 0.0;
  double interval_bias = 0.0;
};
/// The observer keeps a pointer to its parameters: they must outlive it.
Observer draw_observer(const ObserverParameters& parameters, Generator& generator);
Observer draw_observer(ObserverParameters&& parameters, Generator& generator) = delete;

constexpr int kObserverCycles = 1000;   // of an interval
constexpr double kObserverRate = 1000;  // [Hz]

/// Where the hand takes the finger in one interval: a minimum-jerk way in, with this press's own depth and
/// duration, tremor along it and drift across it. One displacement a cycle [m].
/// Source: [Flash1985] for the minimum-jerk course.
std::vector<sim::Vec3> plan_press(const Observer& observer, const sim::Vec3& direction, Generator& generator);

/// Moves the model's first probe along `path`, cycle by cycle, and gives the force back as the device would.
IntervalRecord drive(const sim::Model& model, sim::Simulation& simulation, const std::vector<sim::Vec3>& path,
                     const ForceOutput& output);

/// How stiff the interval felt: logarithm of the least-squares slope of noisy force over noisy depth, with
/// the internal noise that the Weber fraction stands for. Knows nothing but the positions that the finger
/// moved through and the forces that it was given; empty when it felt no force.
std::optional<double> perceive(const Trace& felt, const Observer& observer, Generator& generator);

/// Standard deviation of the difference between two such percepts [-].
double deviation_of_difference(const Observer& observer);

}  // namespace palpate::trials
