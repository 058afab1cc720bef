#include "trials/study/file_check.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <linux/magic.h>
#include <sys/statfs.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <stdexcept>
#include <string_view>
#include <system_error>

#include "trials/study/schema.hpp"

namespace palpate::trials {
namespace {

constexpr std::size_t kHeader =
    100;  // bytes of SQLite's file header, https://www.sqlite.org/fileformat2.html
using Header = std::array<unsigned char, kHeader>;

std::uint32_t big_endian(const Header& header, std::size_t at, std::size_t bytes) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < bytes; ++i) value = value << 8 | header[at + i];
  return value;
}

[[noreturn]] void refuse(const std::filesystem::path& file, const std::string& what) {
  throw std::invalid_argument(fmt::format(
      "{}: {}; accepted: a study file of this program, or a name that is not taken", file.string(), what));
}

Header read_header(const std::filesystem::path& file, std::uintmax_t size) {
  if (size < kHeader) refuse(file, fmt::format("holds {} bytes and is no study file", size));
  Header header{};
  std::ifstream stream(file, std::ios::binary);
  if (!stream.read(reinterpret_cast<char*>(header.data()), kHeader))
    throw std::system_error(errno, std::generic_category(), fmt::format("{}: cannot be read", file.string()));
  return header;
}

bool is_network(const std::filesystem::path& folder) {
  struct statfs system {};
  if (::statfs(folder.c_str(), &system) != 0) return false;
  constexpr std::uint32_t kCifs = 0xFF534D42, kSmb2 = 0xFE534D42;
  const auto type = static_cast<std::uint32_t>(system.f_type);
  return type == NFS_SUPER_MAGIC || type == SMB_SUPER_MAGIC || type == kCifs || type == kSmb2;
}

}  // namespace

void check_is_study_file(const std::filesystem::path& file) {
  if (!std::filesystem::exists(file))
    throw std::invalid_argument(fmt::format("{}: no such file", file.string()));
  if (!std::filesystem::is_regular_file(file)) refuse(file, "is no file");
  const auto size = std::filesystem::file_size(file);
  const Header header = read_header(file, size);
  if (std::memcmp(header.data(), "SQLite format 3", 16) != 0) refuse(file, "is no SQLite database");
  if (big_endian(header, 68, 4) != kApplicationId) refuse(file, "is a database of another program");
  const auto version = static_cast<int>(big_endian(header, 60, 4));
  if (version < 1 || version > kSchemaVersion)
    throw std::invalid_argument(
        fmt::format("{}: has format {}, this program knows 1 to {}; a newer palpate wrote it", file.string(),
                    version, kSchemaVersion));
  const std::uint64_t page = big_endian(header, 16, 2) == 1 ? 65536 : big_endian(header, 16, 2);
  const std::uint64_t claimed = page * big_endian(header, 28, 4);
  // With a write-ahead log beside it the last pages may still be there.
  std::error_code none;
  const auto log = std::filesystem::file_size(file.string() + "-wal", none);
  const auto size_now = std::filesystem::file_size(file);  // after the log's: it may just have been folded in
  if (size_now < claimed && (none || log == 0))
    refuse(file, fmt::format("is cut short: {} bytes of {}", size_now, claimed));
}

void check_writable(const std::filesystem::path& file) {
  const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : ".";
  if (!std::filesystem::is_directory(folder))
    throw std::invalid_argument(
        fmt::format("{}: the folder {} does not exist", file.string(), folder.string()));
  if (is_network(folder))
    throw std::invalid_argument(fmt::format(
        "{}: is on a network drive, where a killed program can lose answers; accepted: a local folder",
        file.string()));
  for (const auto& part : {folder, file})
    if (std::filesystem::exists(part) && ::faccessat(AT_FDCWD, part.c_str(), W_OK, AT_EACCESS) != 0)
      throw std::system_error(errno, std::generic_category(),
                              fmt::format("{}: cannot be written", part.string()));
}

}  // namespace palpate::trials
