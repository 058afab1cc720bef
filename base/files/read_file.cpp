#include "base/files/read_file.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <stdexcept>
#include <system_error>

#include "base/files/file_error.hpp"

namespace palpate::base {
namespace {

[[noreturn]] void refuse(const std::filesystem::path& file, std::string_view what,
                         std::string_view accepted) {
  throw std::invalid_argument(
      fmt::format("{}: {}, accepted: {}", file.string(), what, accepted.empty() ? "a file" : accepted));
}

}  // namespace

std::string read_file(const std::filesystem::path& file, std::string_view accepted) {
  std::error_code error;
  const auto kind = std::filesystem::status(file, error).type();
  if (kind == std::filesystem::file_type::not_found && accepted.empty())
    throw std::invalid_argument(fmt::format("{}: no such file", file.string()));
  if (kind == std::filesystem::file_type::not_found) refuse(file, "no such file", accepted);
  if (kind == std::filesystem::file_type::directory) refuse(file, "is a folder", accepted);
  if (!error && kind != std::filesystem::file_type::regular && kind != std::filesystem::file_type::fifo)
    refuse(file, "is a device", accepted);
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> stream(std::fopen(file.c_str(), "rb"), &std::fclose);
  if (!stream)
    throw std::invalid_argument(
        fmt::format("{}: cannot be read ({})", file.string(), std::generic_category().message(errno)));
  constexpr std::size_t kChunk = std::size_t{1} << 16;
  std::string bytes;
  for (std::size_t got = kChunk; got == kChunk;) {
    const std::size_t before = bytes.size();
    bytes.resize(before + kChunk);
    got = std::fread(bytes.data() + before, 1, kChunk, stream.get());
    bytes.resize(before + got);
  }
  if (std::ferror(stream.get()) != 0) throw_cannot(errno, "read", file);
  return bytes;
}

}  // namespace palpate::base
