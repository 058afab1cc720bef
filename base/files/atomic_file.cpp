#include "base/files/atomic_file.hpp"

#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <list>
#include <string>
#include <system_error>
#include <utility>

#include "base/files/file_error.hpp"
#include "base/files/folder_of.hpp"

namespace palpate::base {
namespace {

void write_all(int descriptor, std::string_view bytes, const std::filesystem::path& file) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) throw_cannot(errno, "write", file);
    bytes.remove_prefix(written);
  }
}

/// A file written and flushed beside where it is to stand; gone again unless it takes its place.
class AsideFile {
 public:
  AsideFile(std::filesystem::path file, std::string_view bytes, ::mode_t mode) : file_(std::move(file)) {
    require_folder_of(file_);
    if (std::error_code none; std::filesystem::is_directory(file_, none))
      throw_cannot(EISDIR, "replace", file_);
    aside_ = file_.string() + ".XXXXXX";
    const int descriptor = ::mkstemp(aside_.data());
    if (descriptor < 0) throw_cannot(errno, "create a file in its folder", file_);
    try {
      write_all(descriptor, bytes, file_);
      if (::fchmod(descriptor, mode) != 0 || ::fsync(descriptor) != 0) throw_cannot(errno, "write", file_);
    } catch (...) {
      ::close(descriptor);
      ::unlink(aside_.c_str());
      throw;
    }
    ::close(descriptor);
  }
  ~AsideFile() {
    if (!aside_.empty()) ::unlink(aside_.c_str());
  }
  AsideFile(const AsideFile&) = delete;
  AsideFile& operator=(const AsideFile&) = delete;

  void take_place() {
    if (::rename(aside_.c_str(), file_.c_str()) != 0) throw_cannot(errno, "replace", file_);
    aside_.clear();
  }

 private:
  std::filesystem::path file_;
  std::string aside_{};
};

}  // namespace

void write_atomically(const std::filesystem::path& file, std::string_view bytes, ::mode_t mode) {
  AsideFile(file, bytes, mode).take_place();
}

void write_together(std::span<const FileText> files, ::mode_t mode) {
  std::list<AsideFile> asides;
  for (const FileText& one : files) asides.emplace_back(one.file, one.text, mode);
  for (AsideFile& aside : asides) aside.take_place();
}

}  // namespace palpate::base
