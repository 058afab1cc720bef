#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <fstream>

#include "sim/compliance/cache.hpp"
#include "sim/compliance/cache_file.hpp"
#include "tests/sim/support/box_mesh.hpp"
#include "tests/support/temporary_folder.hpp"

namespace palpate::sim {
namespace {

/// A small body that is held at all but `loose` of its lowest nodes: each has a compliance of its own.
struct HeldBody {
  explicit HeldBody(std::size_t loose) { fixed.resize(fixed.size() - loose); }

  TetMesh mesh = test::box_mesh(3, 3, 2, Vec3(0.03, 0.03, 0.02));
  std::vector<Material> materials{{.young_modulus = 1.0, .poisson_ratio = 0.4}};
  std::vector<int> fixed = mesh.node_groups.at("z_min");
  std::vector<int> touch = mesh.node_groups.at("z_max");

  void from(ComplianceCache& cache) const { cache.get(mesh, materials, fixed, touch, {}); }
  std::string file() const { return compliance_key(mesh, materials, fixed, touch, {}) + ".compliance"; }
};

class CacheFiles : public testing::Test {
 protected:
  std::filesystem::path at(const std::string& name) const { return folder_.path() / name; }
  bool has(const HeldBody& body) const { return std::filesystem::exists(at(body.file())); }

  const HeldBody first_{0}, second_{1}, third_{2};
  const palpate::test::TemporaryFolder folder_;
};

// Room for two: the one that was used longest ago goes, though it was made after the other.
TEST_F(CacheFiles, KeepToTheirSizeByLastUse) {
  const auto now = std::filesystem::file_time_type::clock::now();
  {
    ComplianceCache whole(folder_.path());
    first_.from(whole);
    second_.from(whole);
  }
  std::filesystem::last_write_time(at(first_.file()), now - std::chrono::hours(2));
  std::filesystem::last_write_time(at(second_.file()), now - std::chrono::hours(1));
  const auto bytes = std::filesystem::file_size(at(first_.file()));
  std::ofstream(at("mine.txt")) << std::string(10 * bytes, 'x');  // not ours: neither counted nor removed
  {
    ComplianceCache reading(folder_.path());
    first_.from(reading);
  }
  EXPECT_GT(std::filesystem::last_write_time(at(first_.file())), now - std::chrono::hours(1));
  ComplianceCache small(folder_.path(), {}, 2 * bytes);
  third_.from(small);
  EXPECT_TRUE(has(first_));
  EXPECT_FALSE(has(second_));
  EXPECT_TRUE(has(third_));
  EXPECT_TRUE(std::filesystem::exists(at("mine.txt")));
}

TEST_F(CacheFiles, OfThisRunStayBeyondTheSize) {
  ComplianceCache none(folder_.path(), {}, 0);
  first_.from(none);
  second_.from(none);
  EXPECT_TRUE(has(first_));
  EXPECT_TRUE(has(second_));
}

}  // namespace
}  // namespace palpate::sim
