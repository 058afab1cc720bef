#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "sim/mesh/quality.hpp"
#include "sim/mesh/read_mesh.hpp"

namespace palpate::app {

/// What `palpate mesh` says about a mesh: size, shape, repairs, groups, warnings.
struct MeshReport {
  std::string file;
  double metres_per_unit = 1.0;
  sim::MeshFile read{};
  sim::MeshQuality quality{};
};

/// Reads, validates and measures a mesh. Throws std::invalid_argument with the file's name.
MeshReport inspect_mesh(const std::string& file, double metres_per_unit);

std::string to_text(const MeshReport& report);
nlohmann::ordered_json to_json(const MeshReport& report);

}  // namespace palpate::app
