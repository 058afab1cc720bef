// 2: materials that no elastic body is made of.
#include <fmt/format.h>

#include <cmath>

#include "tests/hard_cases/runs.hpp"
#include "tests/hard_cases/scenes.hpp"

namespace palpate::hard_cases {

Outcome material_bounds(Jitter& jitter) {
  const auto scene = write_scene(two_boxes(jitter));
  const auto beyond = [&](double bound) {  // by at least nothing
    return fmt::format("{:.17g}", bound + (bound < 0 ? -1 : 1) * std::abs(jitter.part()));
  };
  Outcome outcome;
  for (const std::string& ratio : {beyond(0.5), beyond(0.6), beyond(-1.0), beyond(-7.0), std::string("nan"),
                                   std::string("inf"), std::string("\"half\"")}) {
    const std::string refusal =
        refusal_of(scene, std::vector<sim::Override>{{"bodies.upper.poisson_ratio", ratio}});
    outcome.expect(refusal.find("bodies.upper.poisson_ratio") != std::string::npos,
                   "poisson_ratio = " + ratio);
  }
  for (const std::string& modulus : {std::string("0 Pa"), beyond(-1.0) + " MPa", std::string("nan Pa"),
                                     std::string("inf Pa"), std::string("1 mm"), std::string("1e400 Pa")}) {
    const std::string refusal =
        refusal_of(scene, std::vector<sim::Override>{{"bodies.upper.young_modulus", "\"" + modulus + "\""}});
    outcome.expect(refusal.find("bodies.upper.young_modulus") != std::string::npos,
                   "young_modulus = " + modulus);
  }
  return outcome;
}

}  // namespace palpate::hard_cases
