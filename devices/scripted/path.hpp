#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "sim/mesh/tet_mesh.hpp"

namespace palpate::devices {

/// Where one probe is over time, each place its displacement from where the scene puts it.
struct ProbePath {
  std::string probe{};
  long line = 0;                       // of the file, that names its columns
  std::vector<double> times{};         // ascending [s]
  std::vector<sim::Vec3> places{};     // at these times [m]
  std::vector<sim::Vec3> rotations{};  // likewise, rotation vectors [rad]; empty: the file does not turn it
};

/// The place at a time: linear between two samples, the first one before and the last one after all of them.
sim::Vec3 place_at(const ProbePath& path, double time);

/// The paths in a CSV text: a line of names (`time_s`, then for each probe NAME the columns `NAME.x_m`,
/// `NAME.y_m`, `NAME.z_m` and, all three or none, `NAME.rx_rad`, `NAME.ry_rad`, `NAME.rz_rad`, in any order) and a
/// row for each sample; probes in the order of their first columns. Throws std::invalid_argument,
/// "FILE:LINE: what was found; what is accepted".
std::vector<ProbePath> parse_path(std::string_view text, const std::string& file);

}  // namespace palpate::devices
