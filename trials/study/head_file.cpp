#include "trials/study/head_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <sstream>
#include <stdexcept>
#include <string_view>

#include "base/files/file_error.hpp"
#include "base/files/flush_folder.hpp"
#include "base/files/read_file.hpp"
#include "base/files/sha256.hpp"

namespace palpate::trials {
namespace {

constexpr std::size_t kChecksumDigits = 16;

std::string checksum(std::string_view text) {
  return base::sha256_hex(text).substr(0, kChecksumDigits);
}

/// "palpate-head 1 UUID 00000000000000000120-9f86d0... CHECKSUM\n": one length for all heads of a study.
std::string line_of(const ChainHead& head) {
  const std::string text =
      fmt::format("palpate-head 1 {} {:020}-{}", head.uuid, head.receipt.entries, head.receipt.head);
  return fmt::format("{} {}\n", text, checksum(text));
}

std::optional<ChainHead> head_in(const std::string& line) {
  const auto end = line.rfind(' ');
  if (end == std::string::npos || checksum(line.substr(0, end)) != line.substr(end + 1)) return std::nullopt;
  std::istringstream words(line);
  std::string name, version, uuid, receipt;
  words >> name >> version >> uuid >> receipt;
  if (name != "palpate-head" || version != "1") return std::nullopt;
  return ChainHead{.uuid = uuid, .receipt = parse_receipt(receipt)};
}

class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  ~Descriptor() {
    if (number_ >= 0) ::close(number_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  int number() const { return number_; }

 private:
  int number_;
};

void write_at(int descriptor, std::string_view bytes, std::size_t at, const std::filesystem::path& file) {
  while (!bytes.empty()) {
    const ssize_t written = ::pwrite(descriptor, bytes.data(), bytes.size(), static_cast<off_t>(at));
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) base::throw_cannot(errno, "write", file);
    bytes.remove_prefix(written);
    at += written;
  }
}

}  // namespace

std::filesystem::path head_path(const std::filesystem::path& study) {
  return study.string() + ".head";
}

HeadFile read_head(const std::filesystem::path& study) {
  const std::filesystem::path file = head_path(study);
  std::error_code none;
  if (!std::filesystem::exists(file, none)) return {};
  std::string bytes;
  try {
    bytes = base::read_file(file);
  } catch (const std::exception&) {
    return {.state = HeadFile::State::Unreadable};
  }
  HeadFile found{.state = bytes.empty() ? HeadFile::State::Missing : HeadFile::State::Damaged};
  const std::size_t length = bytes.size() / 2;  // with the line's end, which is not looked at
  for (std::size_t i = 0; length > 0 && i < 2; ++i) {
    const auto head = head_in(bytes.substr(i * length, length - 1));
    if (!head || (found.newest && found.newest->receipt.entries >= head->receipt.entries)) continue;
    found = {.state = HeadFile::State::Good, .newest = head, .newest_line = i};
  }
  return found;
}

void write_head(const std::filesystem::path& study, const ChainHead& head) {
  const HeadFile before = read_head(study);
  if (before.newest == head) return;
  const std::filesystem::path file = head_path(study);
  const Descriptor opened(::open(file.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0600));
  if (opened.number() < 0) base::throw_cannot(errno, "write", file);
  const std::string line = line_of(head);
  if (before.newest && before.newest->uuid == head.uuid) {
    write_at(opened.number(), line, before.newest_line == 0 ? line.size() : 0, file);
  } else {
    write_at(opened.number(), line + line, 0, file);
    if (::ftruncate(opened.number(), static_cast<off_t>(2 * line.size())) != 0)
      base::throw_cannot(errno, "write", file);
  }
  if (::fdatasync(opened.number()) != 0) base::throw_cannot(errno, "write", file);
  if (before.state == HeadFile::State::Missing) base::flush_folder(file);
}

}  // namespace palpate::trials
