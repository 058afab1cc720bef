#include "sim/compliance/cache_file.hpp"

#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <string_view>
#include <system_error>
#include <type_traits>

#include "base/files/atomic_file.hpp"
#include "base/files/sha256.hpp"

namespace palpate::sim {
namespace {

/// To be raised whenever the file's layout changes, and whenever stiffness() or condense() give other numbers
/// for the same input: what older versions wrote is then made anew.
constexpr std::uint64_t kVersion = 1;
constexpr std::size_t kDigestLength = 64;

struct Header {
  std::array<char, 16> magic{"palpate C cache"};
  std::uint64_t version = kVersion;
  std::uint64_t touch = 0, drawn = 0;
  std::array<char, kDigestLength> key{};
  std::array<char, kDigestLength> digest{};  // of all that follows the header
};
static_assert(std::has_unique_object_representations_v<Header>, "no padding in the file");

template <typename Number>
void append(std::string& bytes, const Number* numbers, std::size_t count) {
  static_assert(std::is_trivially_copyable_v<Number>);
  bytes.append(reinterpret_cast<const char*>(numbers), count * sizeof(Number));
}

template <typename Number>
void append_sized(std::string& bytes, std::span<const Number> numbers) {
  const std::uint64_t count = numbers.size();
  append(bytes, &count, 1);
  append(bytes, numbers.data(), numbers.size());
}

template <typename Number>
void take(std::string_view& bytes, Number* numbers, std::size_t count) {
  if (count > 0) std::memcpy(numbers, bytes.data(), count * sizeof(Number));
  bytes.remove_prefix(count * sizeof(Number));
}

std::array<char, kDigestLength> digits(const std::string& hex) {
  std::array<char, kDigestLength> result{};
  hex.copy(result.data(), result.size());
  return result;
}

std::string encode_payload(const Compliance& compliance) {
  const Eigen::MatrixXd& C_TT = compliance.touch_touch;
  std::string bytes;
  append(bytes, compliance.touch.data(), compliance.touch.size());
  append(bytes, compliance.drawn.data(), compliance.drawn.size());
  for (Eigen::Index column = 0; column < C_TT.cols(); ++column)
    append(bytes, C_TT.col(column).data() + column, C_TT.rows() - column);
  append(bytes, compliance.drawn_touch.data(), compliance.drawn_touch.size());
  return bytes;
}

Compliance decode_payload(std::string_view bytes, std::size_t touch, std::size_t drawn) {
  const auto t = static_cast<Eigen::Index>(3 * touch), d = static_cast<Eigen::Index>(3 * drawn);
  Compliance compliance{.touch = std::vector<int>(touch),
                        .drawn = std::vector<int>(drawn),
                        .touch_touch = Eigen::MatrixXd(t, t),
                        .drawn_touch = Eigen::MatrixXf(d, t)};
  take(bytes, compliance.touch.data(), touch);
  take(bytes, compliance.drawn.data(), drawn);
  Eigen::MatrixXd& C_TT = compliance.touch_touch;
  for (Eigen::Index column = 0; column < t; ++column)
    take(bytes, C_TT.col(column).data() + column, t - column);
  C_TT.triangularView<Eigen::StrictlyUpper>() = C_TT.transpose();
  take(bytes, compliance.drawn_touch.data(), static_cast<std::size_t>(d * t));
  return compliance;
}

std::uintmax_t file_size_of(std::uintmax_t touch, std::uintmax_t drawn) {
  const std::uintmax_t t = 3 * touch, d = 3 * drawn;
  return sizeof(Header) + (touch + drawn) * sizeof(int) + t * (t + 1) / 2 * sizeof(double) +
         d * t * sizeof(float);
}

}  // namespace

std::string compliance_key(const TetMesh& mesh, std::span<const Material> materials,
                           std::span<const int> fixed, std::span<const int> touch, std::span<const int> drawn,
                           int interior) {
  static_assert(sizeof(Vec3) == 3 * sizeof(double) && sizeof(Material) == 2 * sizeof(double));
  std::string bytes;
  append(bytes, &kVersion, 1);
  append_sized(bytes, std::span<const double>(mesh.nodes.empty() ? nullptr : mesh.nodes[0].data(),
                                              3 * mesh.nodes.size()));
  append_sized(bytes, std::span<const Tetrahedron>(mesh.tetrahedra));
  append_sized(bytes, std::span<const int>(mesh.region));
  append_sized(bytes, materials);
  append_sized(bytes, fixed);
  append_sized(bytes, touch);
  append_sized(bytes, drawn);
  append(bytes, &interior, 1);
  return base::sha256_hex(bytes);
}

void write_compliance(const std::filesystem::path& file, const std::string& key,
                      const Compliance& compliance) {
  std::filesystem::create_directories(file.parent_path());
  std::string bytes(sizeof(Header), '\0');
  bytes.reserve(file_size_of(compliance.touch.size(), compliance.drawn.size()));
  bytes += encode_payload(compliance);
  const Header header{.touch = compliance.touch.size(),
                      .drawn = compliance.drawn.size(),
                      .key = digits(key),
                      .digest = digits(base::sha256_hex(std::string_view(bytes).substr(sizeof(Header))))};
  std::memcpy(bytes.data(), &header, sizeof(Header));
  base::write_atomically(file, bytes);
}

CompliancePayload read_compliance(const std::filesystem::path& file, const std::string& key,
                                  std::span<const int> touch, std::span<const int> drawn) {
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(file, error);
  if (error == std::errc::no_such_file_or_directory || error == std::errc::not_a_directory) return {};
  const auto refused = [&](const std::string& fault) {
    return CompliancePayload{.compliance = {}, .fault = fmt::format("{}: {}", file.string(), fault)};
  };
  if (error) return refused(error.message());
  const std::uintmax_t expected = file_size_of(touch.size(), drawn.size());
  if (size != expected) return refused(fmt::format("holds {} bytes, must hold {}", size, expected));

  std::string bytes(size, '\0');
  std::ifstream stream(file, std::ios::binary);
  if (!stream.read(bytes.data(), static_cast<std::streamsize>(size))) return refused("cannot be read");
  Header header;
  std::memcpy(&header, bytes.data(), sizeof(Header));
  const std::string_view payload = std::string_view(bytes).substr(sizeof(Header));
  if (header.magic != Header{}.magic) return refused("is no compliance file");
  if (header.version != kVersion)
    return refused(fmt::format("has format version {}, must be {}", header.version, kVersion));
  if (header.key != digits(key) || header.touch != touch.size() || header.drawn != drawn.size())
    return refused("belongs to another body");
  if (header.digest != digits(base::sha256_hex(payload)))
    return refused("its checksum does not fit its content");
  return {.compliance = decode_payload(payload, touch.size(), drawn.size()), .fault = ""};
}

}  // namespace palpate::sim
