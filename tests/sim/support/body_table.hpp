#pragma once

#include <fmt/format.h>

#include <string>

namespace palpate::sim::test {

/// The table of a body in a scene file: NAME.msh in metres, E = 1 MPa, nu = 0.4.
inline std::string body_table(const std::string& name, const std::string& fixed,
                              const std::string& touchable) {
  return fmt::format(
      "[bodies.{0}]\nmesh = \"{0}.msh\"\nlength_unit = \"m\"\nyoung_modulus = \"1 MPa\"\npoisson_ratio = 0.40\n"
      "fixed = \"{1}\"\ntouchable = \"{2}\"\n",
      name, fixed, touchable);
}

/// Two such bodies, "upper" and "lower", that may touch under `model`.
inline std::string two_body_tables(const std::string& upper, const std::string& lower,
                                   const std::string& model) {
  return fmt::format(
      "name = \"two bodies\"\n{}{}[contact]\ntouch = [[\"upper\", \"lower\"]]\nmodel = \"{}\"\n", upper,
      lower, model);
}

}  // namespace palpate::sim::test
