#include "sim/compliance/cache.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <memory>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "sim/compliance/cache_file.hpp"
#include "tests/sim/support/box_mesh.hpp"
#include "tests/support/temporary_folder.hpp"

namespace palpate::sim {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::IsEmpty;

/// A small supported body and all that its compliance depends on.
struct Input {
  TetMesh mesh = test::box_mesh(3, 3, 2, Vec3(0.03, 0.03, 0.02));
  std::vector<Material> materials{{.young_modulus = 1.0, .poisson_ratio = 0.4}};
  std::vector<int> fixed = mesh.node_groups.at("z_min");
  std::vector<int> touch = mesh.node_groups.at("z_max");
  std::vector<int> drawn{20, 21, touch[3]};

  std::shared_ptr<const Compliance> from(ComplianceCache& cache) const {
    return cache.get(mesh, materials, fixed, touch, drawn);
  }
  std::string key() const { return compliance_key(mesh, materials, fixed, touch, drawn); }
};

bool same(const Compliance& a, const Compliance& b) {
  return a.touch == b.touch && a.drawn == b.drawn && a.touch_touch == b.touch_touch &&
         a.drawn_touch == b.drawn_touch;
}

std::string content(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

void put(const fs::path& file, const std::string& bytes) {
  std::ofstream(file, std::ios::binary | std::ios::trunc).write(bytes.data(), std::ssize(bytes));
}

class Cache : public testing::Test {
 protected:
  const Input input_;
  const palpate::test::TemporaryFolder folder_;
  const fs::path file_ = folder_.path() / (input_.key() + ".compliance");
  const Compliance computed_ = *input_.from(*std::make_unique<ComplianceCache>(""));

  std::string written() {
    ComplianceCache cache(folder_.path());
    input_.from(cache);
    return content(file_);
  }

  /// A cache whose troubles are kept in `told_`.
  ComplianceCache listening(const fs::path& folder) {
    return ComplianceCache(folder, [this](const std::string& sentence) { told_ += sentence; });
  }
  std::string told_;
};

TEST_F(Cache, KeepsInMemoryAndOnDisk) {
  ComplianceCache first = listening(folder_.path());
  EXPECT_FALSE(fs::exists(file_));
  const auto built = input_.from(first);
  EXPECT_TRUE(fs::exists(file_));
  EXPECT_TRUE(same(*built, computed_));
  fs::remove(file_);  // what is in memory needs no file, and makes none
  EXPECT_EQ(input_.from(first), built);
  EXPECT_FALSE(fs::exists(file_));

  // From the disk comes what stands there, whoever has computed it.
  Compliance marked = *built;
  marked.touch_touch *= 2.0;
  write_compliance(file_, input_.key(), marked);
  ComplianceCache second = listening(folder_.path());
  EXPECT_TRUE(same(*input_.from(second), marked));
  EXPECT_THAT(told_, IsEmpty());
}

TEST_F(Cache, WithoutFolderKeepsInMemoryOnly) {
  ComplianceCache cache = listening("");
  const auto built = input_.from(cache);
  EXPECT_EQ(input_.from(cache), built);
  EXPECT_THAT(told_, IsEmpty());
}

TEST_F(Cache, LeavesNothingBesideTheFile) {
  written();
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_.path()), {}), 1);
  EXPECT_TRUE(fs::exists(file_));
}

/// Whatever a compliance depends on is in its key; what does not matter is not.
TEST(CacheKey, ChangesWithEverythingThatMatters) {
  const std::vector<std::function<void(Input&)>> changes{
      [](Input& i) { i.mesh.nodes[17].x() += 1e-15; },
      [](Input& i) { std::swap(i.mesh.tetrahedra[0], i.mesh.tetrahedra[1]); },
      [](Input& i) { i.mesh.region[4] = 0, i.mesh.region_names = {"nodule"}; },
      [](Input& i) { i.materials[0].young_modulus = 2.0; },
      [](Input& i) { i.materials[0].poisson_ratio = 0.41; },
      [](Input& i) { i.materials.push_back(i.materials[0]); },
      [](Input& i) { i.fixed.pop_back(); },
      [](Input& i) { i.touch.pop_back(); },
      [](Input& i) { i.drawn.pop_back(); },
      [](Input& i) { std::swap(i.touch, i.drawn); },
      [](Input& i) { i.drawn.insert(i.drawn.begin(), i.touch.back()), i.touch.pop_back(); }};
  std::vector<std::string> keys{Input{}.key()};
  for (const auto& change : changes) {
    Input changed;
    change(changed);
    EXPECT_THAT(keys, testing::Not(testing::Contains(changed.key())));
    keys.push_back(changed.key());
  }
  Input renamed;
  renamed.mesh.node_groups.clear();
  renamed.mesh.node_tags.assign(renamed.mesh.nodes.size(), 5);
  EXPECT_EQ(renamed.key(), keys[0]);
}

TEST_F(Cache, MakesAnewABodyThatChanged) {
  written();
  Input changed;
  changed.mesh.nodes[20].z() += 1e-4;
  ComplianceCache cache(folder_.path());
  const auto other = changed.from(cache);
  EXPECT_TRUE(fs::exists(folder_.path() / (changed.key() + ".compliance")));
  EXPECT_FALSE(other->touch_touch == computed_.touch_touch);
}

/// Hard case 18: each kind of damage is named, and mended by making the compliance anew.
class DamagedCache : public Cache {
 protected:
  void expect_mended(const std::string& damaged, const std::string& fault) {
    const std::string sound = written();
    put(file_, damaged);
    told_.clear();
    ComplianceCache cache = listening(folder_.path());
    EXPECT_TRUE(same(*input_.from(cache), computed_));
    EXPECT_THAT(told_, HasSubstr("made anew"));
    EXPECT_THAT(told_, HasSubstr(file_.string()));
    EXPECT_THAT(told_, HasSubstr(fault));
    EXPECT_EQ(content(file_), sound);
  }
};

TEST_F(DamagedCache, TruncatedAnywhere) {
  const std::string sound = written();
  for (const std::size_t length : {std::size_t{0}, std::size_t{1}, std::size_t{15}, std::size_t{40},
                                   std::size_t{167}, std::size_t{200}, sound.size() / 2, sound.size() - 1})
    expect_mended(sound.substr(0, length), "bytes, must hold " + std::to_string(sound.size()));
}

TEST_F(DamagedCache, WithSomethingAppended) {
  expect_mended(written() + "x", "bytes, must hold ");
}

TEST_F(DamagedCache, FromAnotherVersion) {
  std::string bytes = written();
  ASSERT_EQ(bytes[16], 1);  // the version follows the magic of 16 bytes
  bytes[16] = 2;
  expect_mended(bytes, "has format version 2, must be 1");
}

TEST_F(DamagedCache, StaleUnderTheNameOfThisBody) {
  Input other;
  other.mesh.nodes[20].z() += 1e-4;
  ComplianceCache cache(folder_.path());
  other.from(cache);
  expect_mended(content(folder_.path() / (other.key() + ".compliance")), "belongs to another body");
}

TEST_F(DamagedCache, ForeignFileOfTheRightSize) {
  expect_mended(std::string(written().size(), 'x'), "is no compliance file");
}

TEST_F(DamagedCache, BitsFlippedAnywhere) {
  const std::string sound = written();
  for (std::size_t at = 0; at < sound.size(); at += at < 200 ? 1 : 97) {
    std::string bytes = sound;
    bytes[at] = static_cast<char>(bytes[at] ^ (1 << (at % 8)));
    put(file_, bytes);
    const CompliancePayload read = read_compliance(file_, input_.key(), input_.touch, input_.drawn);
    EXPECT_FALSE(read.compliance.has_value()) << "byte " << at;
    EXPECT_THAT(read.fault, HasSubstr(file_.string())) << "byte " << at;
  }
  std::string last = sound;
  last.back() = static_cast<char>(last.back() ^ 1);
  expect_mended(last, "its checksum does not fit its content");
}

TEST_F(DamagedCache, FolderInPlaceOfTheFile) {
  fs::create_directories(file_ / "occupied");
  ComplianceCache cache = listening(folder_.path());
  EXPECT_TRUE(same(*input_.from(cache), computed_));
  EXPECT_THAT(told_, HasSubstr("made anew"));
  EXPECT_THAT(told_, HasSubstr("not kept for the next run"));
}

TEST_F(Cache, FolderThatCannotBeMadeCostsNothingButTime) {
  put(folder_.path() / "file", "in the way");
  ComplianceCache cache = listening(folder_.path() / "file" / "cache");
  EXPECT_TRUE(same(*input_.from(cache), computed_));
  EXPECT_THAT(told_, HasSubstr("not kept for the next run"));
}

/// A limit on the size of files stands for a full disk: the write fails half-way.
TEST_F(Cache, FullDiskCostsNothingButTimeAndLeavesNothingBehind) {
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  const rlimit small{.rlim_cur = 4096, .rlim_max = before.rlim_max};
  setrlimit(RLIMIT_FSIZE, &small);
  ComplianceCache cache = listening(folder_.path());
  const auto built = input_.from(cache);
  setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  EXPECT_TRUE(same(*built, computed_));
  EXPECT_THAT(told_, HasSubstr("not kept for the next run"));
  EXPECT_TRUE(fs::is_empty(folder_.path()));
}

/// Two processes write the same file over and over while this one reads it: it sees none or a whole one.
TEST_F(Cache, TwoProcessesMayWriteAtOnce) {
  std::vector<pid_t> writers;
  for (int process = 0; process < 2; ++process) {
    const pid_t writer = fork();
    ASSERT_GE(writer, 0);
    if (writer == 0) {
      for (int round = 0; round < 50; ++round) write_compliance(file_, input_.key(), computed_);
      _exit(0);
    }
    writers.push_back(writer);
  }
  int whole = 0, running = 2;
  while (running > 0) {
    const CompliancePayload read = read_compliance(file_, input_.key(), input_.touch, input_.drawn);
    EXPECT_THAT(read.fault, IsEmpty());
    if (read.compliance) whole += same(*read.compliance, computed_) ? 1 : -1000;
    int status = 0;
    while (running > 0 && waitpid(-1, &status, WNOHANG) > 0) {
      EXPECT_EQ(status, 0);
      --running;
    }
  }
  EXPECT_GT(whole, 0);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_.path()), {}), 1);
}

TEST_F(Cache, TwoThreadsWithCachesOfTheirOwnMayShareAFolder) {
  const auto work = [&] {
    for (int round = 0; round < 5; ++round) {
      std::string told;
      ComplianceCache cache(folder_.path(), [&told](const std::string& sentence) { told += sentence; });
      EXPECT_TRUE(same(*input_.from(cache), computed_));
      EXPECT_THAT(told, IsEmpty());
    }
  };
  std::thread one(work), two(work);
  one.join();
  two.join();
}

TEST_F(Cache, PassesOnWhyABodyIsRefused) {
  Input loose;
  loose.fixed = {0, 1};
  ComplianceCache cache(folder_.path());
  EXPECT_THAT([&] { loose.from(cache); },
              testing::ThrowsMessage<std::invalid_argument>(HasSubstr("(nodes 1 and 2)")));
  EXPECT_TRUE(fs::is_empty(folder_.path()));
}

}  // namespace
}  // namespace palpate::sim
