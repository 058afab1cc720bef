#pragma once

#include <string>
#include <vector>

#include "sim/compile/compile.hpp"
#include "sim/compliance/cache.hpp"
#include "sim/model/model.hpp"
#include "sim/scene/scene.hpp"
#include "tests/support/places.hpp"

namespace palpate::app::test {

inline std::string palpation_scene() {
  return palpate::test::source_folder() + "/data/scenes/rectal-palpation.toml";
}

/// The palpation with a contact model and the prostate's modulus, e.g. ("sibille", "5.0 MPa").
inline sim::Model palpation(const std::string& model, const std::string& modulus) {
  static sim::ComplianceCache cache("");  // in memory, shared by all tests of a program
  const std::vector<sim::Override> overrides = {{"contact.model", "\"" + model + "\""},
                                                {"bodies.prostate.young_modulus", "\"" + modulus + "\""}};
  return sim::compile(sim::load_scene(palpation_scene(), overrides), cache);
}

}  // namespace palpate::app::test
