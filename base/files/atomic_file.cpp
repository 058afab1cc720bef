#include "base/files/atomic_file.hpp"

#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <string>

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

}  // namespace

void write_atomically(const std::filesystem::path& file, std::string_view bytes, ::mode_t mode) {
  require_folder_of(file);
  std::string aside = file.string() + ".XXXXXX";
  const int descriptor = ::mkstemp(aside.data());
  if (descriptor < 0) throw_cannot(errno, "create a file in its folder", file);
  try {
    write_all(descriptor, bytes, file);
    if (::fchmod(descriptor, mode) != 0 || ::fsync(descriptor) != 0) throw_cannot(errno, "write", file);
    if (::rename(aside.c_str(), file.c_str()) != 0) throw_cannot(errno, "replace", file);
  } catch (...) {
    ::close(descriptor);
    ::unlink(aside.c_str());
    throw;
  }
  ::close(descriptor);
}

}  // namespace palpate::base
