// 18: compliances on disk that are not what they should be.
#include <filesystem>
#include <fstream>
#include <iterator>
#include <thread>

#include "sim/compliance/cache.hpp"
#include "sim/compliance/cache_file.hpp"
#include "tests/hard_cases/refusal.hpp"
#include "tests/hard_cases/runs.hpp"
#include "tests/sim/support/box_mesh.hpp"
#include "tests/support/temporary_folder.hpp"

namespace palpate::hard_cases {
namespace {

/// A small supported body and all that its compliance depends on.
struct CachedBody {
  TetMesh mesh;
  std::vector<sim::Material> materials{{.young_modulus = 1.0, .poisson_ratio = 0.4}};
  std::vector<int> fixed = mesh.node_groups.at("z_min"), touch = mesh.node_groups.at("z_max"), drawn{20, 21};

  std::string key() const { return sim::compliance_key(mesh, materials, fixed, touch, drawn); }
  Eigen::MatrixXd from(sim::ComplianceCache& cache) const {
    return cache.get(mesh, materials, fixed, touch, drawn)->touch_touch;
  }
};

std::string content_of(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// Two writers of one file, and what a reader meanwhile sees that is neither nothing nor the whole.
int torn_files(const std::filesystem::path& file, const CachedBody& body, const sim::Compliance& compliance) {
  const auto write = [&] {
    for (int round = 0; round < 10; ++round) sim::write_compliance(file, body.key(), compliance);
  };
  std::thread one(write), two(write);
  int torn = 0;
  for (int round = 0; round < 50; ++round) {
    const sim::CompliancePayload read = sim::read_compliance(file, body.key(), body.touch, body.drawn);
    torn += read.compliance ? !(read.compliance->touch_touch == compliance.touch_touch) : !read.fault.empty();
  }
  one.join();
  two.join();
  return torn;
}

}  // namespace

Outcome damaged_cache(Jitter& jitter) {
  Outcome outcome;
  const palpate::test::TemporaryFolder folder;
  const CachedBody body{.mesh = jitter.of(sim::test::box_mesh(3, 3, 2, Vec3(0.03, 0.03, 0.02)), 0.01)};
  CachedBody other = body;
  other.mesh.nodes[20].z() += 1e-4;
  sim::ComplianceCache first(folder.path()), memory("");
  const Eigen::MatrixXd computed = body.from(memory);
  body.from(first);
  other.from(first);
  const auto file = folder.path() / (body.key() + ".compliance");
  const std::string sound = content_of(file);
  std::mt19937_64 random(jitter.seed());
  std::string flipped = sound, other_version = sound;
  flipped[random() % sound.size()] ^= static_cast<char>(1U << random() % 8);
  other_version[16] = 2;  // the version follows the magic of 16 bytes
  for (const std::string& damaged :
       {sound.substr(0, random() % sound.size()), flipped, other_version, sound + "x",
        content_of(folder.path() / (other.key() + ".compliance"))}) {
    std::ofstream(file, std::ios::binary | std::ios::trunc) << damaged;
    std::string told;
    sim::ComplianceCache cache(folder.path(), [&](const std::string& sentence) { told += sentence; });
    outcome.expect(body.from(cache) == computed, "a damaged file is believed");
    outcome.expect(says(told, "made anew"), "a damaged file is not told: " + told);
    outcome.expect(content_of(file) == sound, "it is not mended");
  }
  const sim::Compliance whole = *memory.get(body.mesh, body.materials, body.fixed, body.touch, body.drawn);
  outcome.expect(torn_files(file, body, whole) == 0, "a reader saw half a file");
  return outcome;
}

}  // namespace palpate::hard_cases
