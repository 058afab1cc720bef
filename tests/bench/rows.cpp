#include "tests/bench/rows.hpp"

#include <fmt/format.h>

namespace palpate::bench {
namespace {

using Calls = std::vector<sim::Override>;

constexpr const char* kOrgans = "rectal-palpation-fine";
constexpr const char* kSphere = "sphere-on-cube-0799";

Calls model(const std::string& law) {
  return {{"contact.model", fmt::format("\"{}\"", law)}};
}

Calls exact_and(const std::string& key, const std::string& value) {
  Calls calls = model("exact");
  calls.push_back({key, value});
  return calls;
}

/// The finger of the organs' scene with another kind.
Calls finger(const std::string& kind) {
  return exact_and(
      "probes.finger",
      fmt::format("{{ body = \"rectum\", at = [\"0 mm\", \"0 mm\", \"12 mm\"], direction = [0, 0, 1], "
                  "depth = \"5 mm\", {} }}",
                  kind));
}

/// The sphere, with nothing to hold it but the two caps at its sides, that go down.
Calls caps(const std::string& reach) {
  Calls calls =
      exact_and("bodies.sphere",
                "{ mesh = \"../meshes/sphere-0799.msh\", length_unit = \"m\", young_modulus = \"1.0 MPa\", "
                "poisson_ratio = 0.40, touchable = \"contact\" }");
  calls.push_back({"probes.finger", fmt::format("{{ body = \"sphere\", kind = \"region\", group = \"fixed\", "
                                                "direction = [0, 0, -1], depth = \"5 mm\"{} }}",
                                                reach)});
  return calls;
}

constexpr const char* kPad = "kind = \"pad\", radius = \"7 mm\"";
constexpr const char* kSlidingPad = "kind = \"pad\", radius = \"7 mm\", reach = \"4 mm\"";
constexpr const char* kFingertip = "kind = \"fingertip\", radius = \"7 mm\"";
constexpr const char* kSlidingFingertip = "kind = \"fingertip\", radius = \"7 mm\", reach = \"4 mm\"";

}  // namespace

std::vector<Row> rows() {
  return {
      {"none", "", kOrgans, model("none")},
      {"sibille", "none", kOrgans, model("sibille")},
      {"kuroda", "none", kOrgans, model("kuroda")},
      {"exact", "none", kOrgans, model("exact")},
      {"tolerance 1 %", "exact", kOrgans, exact_and("contact.tolerance", "\"1 %\"")},
      {"friction 0.3", "exact", kOrgans, exact_and("contact.friction", "0.3")},
      {"pad", "exact", kOrgans, finger(kPad)},
      {"pad with reach", "pad", kOrgans, finger(kSlidingPad)},
      {"pad that slides", "pad with reach", kOrgans, finger(kSlidingPad), true},
      {"fingertip", "pad", kOrgans, finger(kFingertip)},
      {"fingertip with reach", "fingertip", kOrgans, finger(kSlidingFingertip)},
      {"fingertip that slides", "fingertip with reach", kOrgans, finger(kSlidingFingertip), true},
      {"point on sphere", "", kSphere, model("exact")},
      {"region", "point on sphere", kSphere, caps("")},
      {"region with reach", "region", kSphere, caps(", reach = \"10 mm\"")},
  };
}

std::vector<Family> families() {
  std::vector<Family> all;
  for (const char* law : {"none", "sibille", "kuroda", "exact"}) {
    Family family{.law = law};
    for (const char* nodes : {"0191", "0410", "0799", "1565"})
      family.sizes.push_back({fmt::format("{} with {} nodes", law, nodes), "",
                              fmt::format("sphere-on-cube-{}", nodes), model(law)});
    all.push_back(std::move(family));
  }
  return all;
}

}  // namespace palpate::bench
