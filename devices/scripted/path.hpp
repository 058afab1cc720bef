#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "sim/mesh/tet_mesh.hpp"

namespace palpate::devices {

/// Where one probe is over time, each place its displacement from where the scene puts it.
struct ProbePath {
  std::string probe{};
  std::vector<double> times{};      // ascending [s]
  std::vector<sim::Vec3> places{};  // at these times [m]
};

/// The place at a time: linear between two samples, the first one before and the last one after all of them.
sim::Vec3 place_at(const ProbePath& path, double time);

/// The paths in a CSV text: a line of names (`time_s`, then for each probe NAME the columns `NAME.x_m`,
/// `NAME.y_m`, `NAME.z_m`, in any order of probes) and a row for each sample. Throws std::invalid_argument,
/// "FILE:LINE: what was found; what is accepted".
std::vector<ProbePath> parse_path(std::string_view text, const std::string& file);

}  // namespace palpate::devices
