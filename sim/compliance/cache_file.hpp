#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>

#include "sim/compliance/compliance.hpp"
#include "sim/elasticity/stiffness.hpp"
#include "sim/mesh/tet_mesh.hpp"

namespace palpate::sim {

/// SHA-256 over everything that a compliance depends on, in one defined order of bytes.
std::string compliance_key(const TetMesh& mesh, std::span<const Material> materials,
                           std::span<const int> fixed, std::span<const int> touch, std::span<const int> drawn,
                           int interior = 0);

/// Writes a compliance under its key: magic, format version, sizes, key, SHA-256 of the rest, then touch,
/// drawn, the lower triangle of C_TT column by column, C_DT; numbers as this machine stores them.
/// Makes the folder where there is none. Throws std::system_error when the disk refuses.
void write_compliance(const std::filesystem::path& file, const std::string& key,
                      const Compliance& compliance);

struct CompliancePayload {
  std::optional<Compliance> compliance;
  std::string fault;  // why there is none; empty when there is no such file
};

/// Reads what write_compliance wrote under this key. Nothing is believed of a file before its size, key and
/// checksum agree with what was asked, and no memory is taken before its size does.
CompliancePayload read_compliance(const std::filesystem::path& file, const std::string& key,
                                  std::span<const int> touch, std::span<const int> drawn);

}  // namespace palpate::sim
