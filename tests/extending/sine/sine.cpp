#include "tests/extending/sine/sine.hpp"

#include <cmath>
#include <numbers>

namespace palpate::devices {
namespace {

constexpr double kDeepest = 2e-3;  // [m]
constexpr double kPeriod = 1.0;    // [s]

std::unique_ptr<Handle> open(const std::string&) {
  return std::make_unique<Handle>();
}

Reading read(Handle&, const Moment& moment) {
  const double phase = 2.0 * std::numbers::pi * moment.since_begin / kPeriod;
  return {.position = 0.5 * kDeepest * (1.0 - std::cos(phase)) * moment.press,
          .measured = moment.now,
          .known = true};
}

void move(DrivenProbe& probe, const Vec3& target, double, double step) {
  hold_probe(probe, target, step);
}

}  // namespace

const Device& sine() {
  static const Device device{.name = "sine",
                             .in_words = "a sine",
                             .notice = "No person moves this session's hand: it follows a sine.",
                             .facts = {.moved_by_a_person = false, .rate = 1000.0},
                             .open = open,
                             .read = read,
                             .move = move};
  return device;
}

}  // namespace palpate::devices
