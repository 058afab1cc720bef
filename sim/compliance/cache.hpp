#pragma once

#include <cstdint>
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
  static constexpr std::uintmax_t kDefaultSize = std::uintmax_t{2} << 30;  // [byte]

  /// @param folder   empty: memory only
  /// @param trouble  told, in a sentence for the user, what went wrong without stopping the run
  /// @param size     what the folder may hold [byte]: after each file that is added, those that were used
  ///                 longest ago are removed, but none that this cache has used
  explicit ComplianceCache(std::filesystem::path folder,
                           std::function<void(const std::string& sentence)> trouble = {},
                           std::uintmax_t size = kDefaultSize);

  /// The folder that the program uses: $PALPATE_CACHE, else $XDG_CACHE_HOME/palpate, else ~/.cache/palpate.
  static std::filesystem::path default_folder();

  /// $PALPATE_CACHE_SIZE [byte], given as "500 MiB" or "2 GiB", else kDefaultSize. Throws
  /// std::invalid_argument for what is no such size.
  static std::uintmax_t size_asked_for();

  /// The compliance of the supported body, from memory, disk or condense(): of the mesh's stiffness, or of that which
  /// finer_inside() has with so many cuts.
  /// Bodies of one material have it at E = 1 Pa, so that a change of stiffness finds the same entry.
  /// Throws std::invalid_argument as stiffness() and condense() do.
  std::shared_ptr<const Compliance> get(const TetMesh& mesh, std::span<const Material> materials,
                                        std::span<const int> fixed, std::span<const int> touch,
                                        std::span<const int> drawn, int interior = 0);

 private:
  void trim() const;

  std::filesystem::path folder_;
  std::uintmax_t size_;
  std::function<void(const std::string&)> tell_trouble_;
  std::map<std::string, std::shared_ptr<const Compliance>> in_memory_;
};

}  // namespace palpate::sim
