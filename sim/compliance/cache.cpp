#include "sim/compliance/cache.hpp"

#include <fmt/format.h>

#include <optional>
#include <system_error>
#include <utility>

#include "base/machine/environment.hpp"
#include "sim/compliance/cache_file.hpp"
#include "sim/elasticity/supports.hpp"

namespace palpate::sim {

ComplianceCache::ComplianceCache(std::filesystem::path folder,
                                 std::function<void(const std::string&)> trouble)
    : folder_(std::move(folder)), tell_trouble_(std::move(trouble)) {}

std::filesystem::path ComplianceCache::default_folder() {
  if (const auto own = base::environment("PALPATE_CACHE")) return *own;
  const std::filesystem::path shared = base::environment("XDG_CACHE_HOME").value_or("");
  if (shared.is_absolute()) return shared / "palpate";  // the XDG rule: ignore relative ones
  if (const auto home = base::environment("HOME")) return std::filesystem::path(*home) / ".cache" / "palpate";
  return {};
}

std::shared_ptr<const Compliance> ComplianceCache::get(const TetMesh& mesh,
                                                       std::span<const Material> materials,
                                                       std::span<const int> fixed, std::span<const int> touch,
                                                       std::span<const int> drawn) {
  const std::string key = compliance_key(mesh, materials, fixed, touch, drawn);
  if (const auto known = in_memory_.find(key); known != in_memory_.end()) return known->second;

  const std::filesystem::path file = folder_ / (key + ".compliance");
  std::string trouble;
  if (!folder_.empty()) {
    CompliancePayload read = read_compliance(file, key, touch, drawn);
    if (read.compliance)
      return in_memory_[key] = std::make_shared<const Compliance>(std::move(*read.compliance));
    if (!read.fault.empty()) trouble = read.fault + "; made anew";
  }

  require_supports(mesh, fixed);
  auto built = std::make_shared<const Compliance>(condense(stiffness(mesh, materials), fixed, touch, drawn));
  try {
    if (!folder_.empty()) write_compliance(file, key, *built);
  } catch (const std::system_error& refusal) {
    if (!trouble.empty()) trouble += "; ";
    trouble += fmt::format("the compliance is not kept for the next run: {}", refusal.what());
  }
  if (tell_trouble_ && !trouble.empty()) tell_trouble_(trouble);
  return in_memory_[key] = std::move(built);
}

}  // namespace palpate::sim
