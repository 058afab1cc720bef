#include "sim/compliance/cache.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "base/machine/cache_folder.hpp"
#include "base/machine/environment.hpp"
#include "sim/compliance/cache_file.hpp"
#include "sim/elasticity/finer_inside.hpp"
#include "sim/elasticity/supports.hpp"

namespace palpate::sim {
namespace {

namespace fs = std::filesystem;

constexpr const char* kEnding = ".compliance";
constexpr const char* kConvertedMesh = ".converted";  // beside them (sim/mesh/convert_mesh.cpp)

}  // namespace

ComplianceCache::ComplianceCache(std::filesystem::path folder,
                                 std::function<void(const std::string&)> trouble, std::uintmax_t size)
    : folder_(std::move(folder)), size_(size), tell_trouble_(std::move(trouble)) {}

std::filesystem::path ComplianceCache::default_folder() {
  return base::cache_folder();
}

std::uintmax_t ComplianceCache::size_asked_for() {
  const auto asked = base::environment("PALPATE_CACHE_SIZE");
  if (!asked) return kDefaultSize;
  std::uintmax_t count = 0;
  const char* const end = asked->data() + asked->size();
  const auto read = std::from_chars(asked->data(), end, count);
  std::string_view unit(read.ptr, static_cast<std::size_t>(end - read.ptr));
  if (unit.starts_with(' ')) unit.remove_prefix(1);
  const int shift = unit == "GiB" ? 30 : unit == "MiB" ? 20 : 0;
  if (read.ec != std::errc() || shift == 0 || count > (std::numeric_limits<std::uintmax_t>::max() >> shift))
    throw std::invalid_argument(fmt::format(
        "PALPATE_CACHE_SIZE: found \"{}\", accepted: a whole number of MiB or GiB, as \"500 MiB\" "
        "or \"2 GiB\"",
        *asked));
  return count << shift;
}

// Files that go away meanwhile, or that cannot be removed, are left: another process trims as well.
void ComplianceCache::trim() const {
  struct Kept {
    fs::path path;
    fs::file_time_type used;
    std::uintmax_t bytes = 0;
  };
  std::vector<Kept> files;
  std::uintmax_t all = 0;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder_, error)) {
    if (entry.path().extension() != kEnding && entry.path().extension() != kConvertedMesh) continue;
    std::error_code gone;
    const Kept file{entry.path(), entry.last_write_time(gone), entry.file_size(gone)};
    if (gone) continue;
    all += file.bytes;
    if (!in_memory_.contains(file.path.stem().string())) files.push_back(file);
  }
  std::ranges::sort(files, {}, &Kept::used);
  for (const Kept& file : files) {
    if (all <= size_) return;
    if (fs::remove(file.path, error)) all -= file.bytes;
  }
}

std::shared_ptr<const Compliance> ComplianceCache::get(const TetMesh& mesh,
                                                       std::span<const Material> materials,
                                                       std::span<const int> fixed, std::span<const int> touch,
                                                       std::span<const int> drawn, int interior) {
  const std::string key = compliance_key(mesh, materials, fixed, touch, drawn, interior);
  if (const auto known = in_memory_.find(key); known != in_memory_.end()) return known->second;

  const std::filesystem::path file = folder_ / (key + kEnding);
  std::string trouble;
  if (!folder_.empty()) {
    CompliancePayload read = read_compliance(file, key, touch, drawn);
    if (read.compliance) {
      std::error_code ignored;  // of a folder that may only be read
      fs::last_write_time(file, fs::file_time_type::clock::now(), ignored);
      return in_memory_[key] = std::make_shared<const Compliance>(std::move(*read.compliance));
    }
    if (!read.fault.empty()) trouble = read.fault + "; made anew";
  }

  require_supports(mesh, fixed);
  const FinerBody finer = finer_inside(mesh, materials, touch, interior);
  auto built = std::make_shared<const Compliance>(
      condense(finer.K, with_added(finer, {fixed.begin(), fixed.end()}), touch, drawn));
  try {
    if (!folder_.empty()) write_compliance(file, key, *built);
  } catch (const std::system_error& refusal) {
    if (!trouble.empty()) trouble += "; ";
    trouble += fmt::format("the compliance is not kept for the next run: {}", refusal.what());
  }
  if (tell_trouble_ && !trouble.empty()) tell_trouble_(trouble);
  in_memory_[key] = built;
  if (!folder_.empty()) trim();
  return built;
}

}  // namespace palpate::sim
