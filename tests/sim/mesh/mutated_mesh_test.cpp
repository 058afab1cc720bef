#include <gtest/gtest.h>

#include <filesystem>
#include <random>

#include "sim/mesh/parse_mesh.hpp"
#include "sim/mesh/quality.hpp"
#include "tests/sim/mesh/fixtures.hpp"
#include "tests/support/places.hpp"

// Damaged files give a sound mesh or a refusal, and no other end: no crash, no other exception, no endless
// reading.
namespace palpate::sim::test {
namespace {

void read_damaged(const std::string& bytes, const std::string& what) {
  try {
    const TetMesh mesh = parse_mesh(bytes, "damaged", 1.0).mesh;
    ASSERT_EQ(mesh.nodes.size(), mesh.node_tags.size()) << what;
    ASSERT_EQ(mesh.tetrahedra.size(), mesh.region.size()) << what;
    measure_quality(mesh);
    validate(mesh);
  } catch (const std::invalid_argument& error) {
    ASSERT_GT(std::string(error.what()).size(), 20U) << what;
  }
}

class DamagedMesh : public testing::TestWithParam<std::string> {
 protected:
  std::string whole_ = read_bytes(data_file(GetParam()));
  std::mt19937_64 random_{20030101};
  std::size_t somewhere() {
    return std::uniform_int_distribution<std::size_t>(0, whole_.size() - 1)(random_);
  }
};

TEST_P(DamagedMesh, TruncatedAtEveryByte) {
  for (std::size_t length = 0; length < whole_.size(); ++length)
    read_damaged(whole_.substr(0, length), "cut after " + std::to_string(length));
}

TEST_P(DamagedMesh, WithFlippedBits) {
  for (int i = 0; i < 3000; ++i) {
    std::string bytes = whole_;
    const std::size_t at = somewhere(), bit = somewhere() % 8;
    bytes[at] = static_cast<char>(static_cast<unsigned char>(bytes[at]) ^ (1U << bit));
    read_damaged(bytes, "bit " + std::to_string(bit) + " of byte " + std::to_string(at));
  }
}

TEST_P(DamagedMesh, WithOtherDigits) {
  constexpr std::string_view kDigits = "0123456789-.,e \n\"";
  for (int i = 0; i < 3000; ++i) {
    std::string bytes = whole_;
    std::size_t at = somewhere();
    for (std::size_t tries = 0; tries < bytes.size() && (bytes[at] < '0' || bytes[at] > '9'); ++tries)
      at = (at + 1) % bytes.size();
    bytes[at] = kDigits[somewhere() % kDigits.size()];
    read_damaged(bytes, "byte " + std::to_string(at));
  }
}

TEST_P(DamagedMesh, WithPartsExchangedDoubledAndLeftOut) {
  for (int i = 0; i < 1000; ++i) {
    const std::size_t from = somewhere(), length = somewhere() % 200, to = somewhere();
    const std::string part = whole_.substr(from, length);
    std::string bytes = whole_;
    if (i % 2 == 0) bytes.erase(from, length);
    if (i % 3 != 0) bytes.insert(std::min(to, bytes.size()), part);
    read_damaged(bytes, "part of " + std::to_string(length) + " bytes at " + std::to_string(from));
  }
}

// Inputs by which libFuzzer reached new branches of the readers, and any that once failed:
// tests/fuzz/README.md.
TEST(FuzzedMesh, KeptInputsEndWell) {
  int read = 0;
  for (const auto& entry : std::filesystem::directory_iterator(
           std::filesystem::path(palpate::test::source_folder()) / "tests/fuzz/read_mesh")) {
    read_damaged(read_bytes(entry.path()), entry.path().string());
    ++read;
  }
  EXPECT_GT(read, 0);
}

INSTANTIATE_TEST_SUITE_P(Fixtures, DamagedMesh,
                         testing::Values("two_boxes.v22.text.msh", "two_boxes.v22.binary.msh",
                                         "two_boxes.v41.text.msh", "two_boxes.v41.binary.msh",
                                         "two_boxes.ascii.plain.uint32.little.vtu",
                                         "two_boxes.inline.zlib.uint32.little.vtu",
                                         "two_boxes.appended.base64.plain.uint64.little.vtu",
                                         "two_boxes.appended.raw.zlib.uint64.big.vtu"),
                         [](const auto& file) {
                           std::string name = file.param;
                           for (char& c : name) c = c == '.' ? '_' : c;
                           return name;
                         });

}  // namespace
}  // namespace palpate::sim::test
