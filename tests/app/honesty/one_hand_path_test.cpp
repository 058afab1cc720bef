#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <numbers>
#include <regex>

#include "app/loop/interval_engine.hpp"
#include "app/web/pages/examinee/messages.hpp"
#include "devices/mouse/mouse.hpp"
#include "sim/compliance/cache.hpp"
#include "tests/support/places.hpp"
#include "trials/protocol/stimuli.hpp"

namespace palpate::app {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> shipped_protocols() {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(fs::path(test::source_folder()) / "protocols"))
    if (entry.path().extension() == ".toml") names.push_back(entry.path().stem());
  return names;
}

/// What a page hears of one interval, without the declared channel: the pointer's place.
struct Heard {
  std::vector<std::string> messages{};
  trials::Verdict verdict{};

  bool operator==(const Heard&) const = default;
};

/// The hand goes in and out to `deepest`, a press a second, as long as the interval lasts.
Heard heard_from(const sim::Model& model, const trials::Exploration& rule, double deepest) {
  IntervalEngine engine(model,
                        {.least_presses = rule.least_presses,
                         .most_presses = rule.most_presses,
                         .min_depth = rule.min_depth,
                         .max_time = rule.max_time},
                        devices::mouse());
  Heard heard;
  for (std::uint32_t tick = 0; !engine.state().over; ++tick) {
    const double depth = 0.5 * (deepest - 1e-3) -
                         0.5 * (deepest + 1e-3) * std::cos(2 * std::numbers::pi * tick * kCycleSeconds);
    engine.tick({.position = depth * engine.press(), .known = true});
    if (tick % 16 != 0) continue;
    std::string message = encode_probe(engine.state(), tick / 16);
    message.replace(8, 4, 4, '\0');
    heard.messages.push_back(message);
  }
  heard.verdict = trials::judge(trials::summarise(engine.trace()), rule);
  return heard;
}

class OneHandPath : public testing::TestWithParam<std::string> {};

// With a mouse the probe goes less deep in stiffer tissue. Neither the button that comes alive, nor what is asked
// for once more, nor how many messages there are may tell of it.
TEST_P(OneHandPath, IsToldTheSameInEveryConditionUnderEveryModel) {
  const auto protocol =
      trials::load_protocol(fs::path(test::source_folder()) / "protocols" / (GetParam() + ".toml"));
  sim::ComplianceCache cache("");
  const trials::Stimuli stimuli = trials::compile_stimuli(protocol, cache);
  const double asked = protocol.exploration.min_depth;
  for (const double deepest : {0.9 * asked, 1.02 * asked, 1.3 * asked, 2.0 * asked}) {
    std::optional<Heard> first;
    for (const auto& stimulus : stimuli) {
      if (!stimulus) continue;  // in no trial
      const Heard heard = heard_from(*stimulus, protocol.exploration, deepest);
      if (!first) first = heard;
      EXPECT_EQ(heard, *first) << deepest;
    }
    ASSERT_TRUE(first);
    EXPECT_EQ(first->verdict, deepest < asked ? trials::Verdict::TooShallow : trials::Verdict::Enough);
  }
}

INSTANTIATE_TEST_SUITE_P(Protocols, OneHandPath, testing::ValuesIn(shipped_protocols()),
                         [](const auto& name) {
                           return std::regex_replace(name.param, std::regex("-"), "_");
                         });

}  // namespace
}  // namespace palpate::app
