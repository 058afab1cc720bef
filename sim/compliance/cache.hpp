#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <span>
#include <string>

#include "sim/compliance/compliance.hpp"
#include "sim/elasticity/stiffness.hpp"
#include "sim/mesh/tet_mesh.hpp"

namespace palpate::sim {

/// Compliances kept in memory and on disk under the SHA-256 of all that they depend on (format version, mesh,
/// materials, supports, touched and drawn nodes). A file that is truncated, altered or of another version is
/// found by its checksum, and made anew. A folder that cannot be written costs the saving of time, never the
/// run.
class ComplianceCache {
 public:
  /// @param folder  empty: memory only
  explicit ComplianceCache(std::filesystem::path folder);

  /// The folder that the program uses: $PALPATE_CACHE, else $XDG_CACHE_HOME/palpate, else ~/.cache/palpate.
  static std::filesystem::path default_folder();

  std::shared_ptr<const Compliance> get(const TetMesh& mesh, std::span<const Material> materials,
                                        std::span<const int> fixed, std::span<const int> touch,
                                        std::span<const int> drawn);

 private:
  std::filesystem::path folder_;
  std::map<std::string, std::shared_ptr<const Compliance>> in_memory_;
};

}  // namespace palpate::sim
