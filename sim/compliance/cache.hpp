#pragma once

#include <filesystem>
#include <functional>
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
/// run. Several caches, in threads or processes, may share a folder; one cache belongs to one thread.
class ComplianceCache {
 public:
  /// @param folder   empty: memory only
  /// @param trouble  told, in a sentence for the user, what went wrong without stopping the run
  explicit ComplianceCache(std::filesystem::path folder,
                           std::function<void(const std::string& sentence)> trouble = {});

  /// The folder that the program uses: $PALPATE_CACHE, else $XDG_CACHE_HOME/palpate, else ~/.cache/palpate.
  static std::filesystem::path default_folder();

  /// The compliance of the supported body, from memory, disk or condense(stiffness(mesh, materials), ...).
  /// Bodies of one material have it at E = 1 Pa, so that a change of stiffness finds the same entry.
  /// Throws std::invalid_argument as stiffness() and condense() do.
  std::shared_ptr<const Compliance> get(const TetMesh& mesh, std::span<const Material> materials,
                                        std::span<const int> fixed, std::span<const int> touch,
                                        std::span<const int> drawn);

 private:
  std::filesystem::path folder_;
  std::function<void(const std::string&)> tell_trouble_;
  std::map<std::string, std::shared_ptr<const Compliance>> in_memory_;
};

}  // namespace palpate::sim
