#include "trials/observer/observer_keys.hpp"

#include <array>

namespace palpate::trials {
namespace {

using base::Dimension;
using base::Key;

constexpr base::Takes positive(Dimension dimension) {
  return base::takes_quantity(dimension, base::kPositive);
}
constexpr base::Takes not_negative(Dimension dimension) {
  return base::takes_quantity(dimension, base::kNotNegative);
}

constexpr std::array kObserverKeys{
    Key{.name = "name",
        .takes = base::kText,
        .example = "\"my-observers\"",
        .meaning = "What these simulated examinees are called; it is stored with their sessions."},
    Key{.name = "press", .takes = base::takes_table("a table [press]")},
    Key{.name = "device", .takes = base::takes_table("a table [device]")},
    Key{.name = "senses", .takes = base::takes_table("a table [senses]")},
    Key{.name = "decision", .takes = base::takes_table("a table [decision]")},
};

constexpr std::array kPressKeys{
    Key{.name = "depth",
        .takes = positive(Dimension::Length),
        .example = "\"4.5 mm\"",
        .meaning = "The deepest point that the hand aims at."},
    Key{.name = "depth_between_examinees",
        .takes = not_negative(Dimension::Length),
        .example = "\"0.2 mm\"",
        .meaning = "How much that differs between examinees."},
    Key{.name = "depth_within_examinee",
        .takes = not_negative(Dimension::Length),
        .example = "\"0.2 mm\"",
        .meaning = "How much it differs between one examinee's presses."},
    Key{.name = "duration",
        .takes = positive(Dimension::Time),
        .example = "\"0.6 s\"",
        .meaning = "How long the way in takes; for the rest of the second the finger stays."},
    Key{.name = "duration_between_examinees",
        .takes = not_negative(Dimension::Time),
        .example = "\"0.05 s\"",
        .meaning = "How much that differs between examinees."},
    Key{.name = "duration_within_examinee",
        .takes = not_negative(Dimension::Time),
        .example = "\"0.05 s\"",
        .meaning = "How much it differs between one examinee's presses."},
    Key{.name = "tremor",
        .takes = not_negative(Dimension::Length),
        .example = "\"0.05 mm\"",
        .meaning = "How far the hand trembles along the press (root mean square)."},
    Key{.name = "tremor_period",
        .takes = positive(Dimension::Time),
        .example = "\"0.1 s\"",
        .meaning = "How long one tremble takes."},
    Key{.name = "drift",
        .takes = not_negative(Dimension::Length),
        .example = "\"0.1 mm\"",
        .meaning = "How far the hand drifts sideways (root mean square, in each direction)."},
    Key{.name = "drift_period",
        .takes = positive(Dimension::Time),
        .example = "\"2 s\"",
        .meaning = "How long one drift to and fro takes."},
};

constexpr std::array kDeviceKeys{
    Key{.name = "force_scale",
        .takes = base::takes_number({.least = 1e-6, .most = 1e6}),
        .example = "0.08",
        .meaning = "What the scene's force is multiplied with before the device gives it."},
    Key{.name = "max_force",
        .takes = positive(Dimension::Force),
        .example = "\"8.5 N\"",
        .meaning =
            "The largest force that the device gives; more is cut. Conditions that this makes alike are "
            "refused."},
};

constexpr std::array kSensesKeys{
    Key{.name = "force_noise",
        .takes = not_negative(Dimension::Force),
        .example = "\"0.02 N\"",
        .meaning = "Noise of each of the 1000 samples of force (standard deviation)."},
    Key{.name = "position_noise",
        .takes = not_negative(Dimension::Length),
        .example = "\"0.1 mm\"",
        .meaning = "Noise of each sample of position (standard deviation)."},
    Key{.name = "weber_fraction",
        .takes = base::takes_number({.least = 1e-6, .most = 10.0}),
        .example = "0.23",
        .meaning =
            "The relative difference of stiffness at which 75 % of two-interval answers are correct. This is "
            "what limits an observer."},
    Key{.name = "weber_fraction_between_examinees",
        .takes = base::takes_number({.least = 0.0, .most = 10.0}),
        .example = "0.05",
        .meaning = "How much that differs between examinees."},
};

constexpr std::array kDecisionKeys{
    Key{.name = "lapse_rate",
        .takes = base::takes_number({.least = 0.0, .most = 1.0}),
        .example = "0.02",
        .meaning = "The share of questions that are answered by a coin."},
    Key{.name = "interval_bias",
        .takes = base::takes_number({.least = -10.0, .most = 10.0}),
        .example = "0.0",
        .meaning =
            "How much the second interval is favoured, in standard deviations of the felt difference; below "
            "0 the first."},
    Key{.name = "interval_bias_between_examinees",
        .takes = base::takes_number({.least = 0.0, .most = 10.0}),
        .example = "0.1",
        .meaning = "How much that differs between examinees."},
};

constexpr std::string_view kIntroduction =
    "An observer file says what simulated examinees are like: hand, senses and decision. `simulate` and `plan "
    "--studies` take one with `--observer FILE`; without it they take `protocols/observers/default.toml`, which "
    "gives the source of every figure. `between_examinees` and `within_examinee` are standard deviations.";

void add_table(const std::string& path, std::string_view meaning, std::span<const Key> keys,
               base::FileFormat& format) {
  format.tables.push_back(
      {.path = path, .meaning = meaning, .keys = {keys.begin(), keys.end()}, .shown = {{.path = path}}});
}

}  // namespace

std::span<const Key> observer_keys() {
  return kObserverKeys;
}
std::span<const Key> press_keys() {
  return kPressKeys;
}
std::span<const Key> device_keys() {
  return kDeviceKeys;
}
std::span<const Key> senses_keys() {
  return kSensesKeys;
}
std::span<const Key> decision_keys() {
  return kDecisionKeys;
}

base::FileFormat observer_format() {
  base::FileFormat format{.name = "observer", .introduction = kIntroduction};
  add_table("", "", kObserverKeys, format);
  add_table("press", "The hand: one press of an interval, of 1 s.", kPressKeys, format);
  add_table("device", "How the scene's force reaches the finger.", kDeviceKeys, format);
  add_table("senses", "What is perceived.", kSensesKeys, format);
  add_table("decision", "How the answer is given.", kDecisionKeys, format);
  return format;
}

}  // namespace palpate::trials
