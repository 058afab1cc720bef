#include "trials/study/session_lock.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <system_error>

namespace palpate::trials {
namespace {

/// " (pid 123)" of who holds an flock on the file, from /proc/locks ("1: FLOCK ADVISORY WRITE 123
/// 08:01:4711 0 EOF", device numbers in hexadecimal); empty where the system does not tell.
std::string told_holder(int descriptor) {
  struct stat file {};
  if (::fstat(descriptor, &file) != 0) return "";
  const std::string inode = fmt::format(":{}", file.st_ino);
  std::ifstream locks("/proc/locks");
  for (std::string line; std::getline(locks, line);) {
    std::istringstream words(line);
    std::string number, kind, advisory, access, place;
    long pid = 0;
    words >> number >> kind >> advisory >> access >> pid >> place;
    if (words && kind == "FLOCK" && pid > 0 && place.ends_with(inode)) return fmt::format(" (pid {})", pid);
  }
  return "";
}

}  // namespace

SessionLock::~SessionLock() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

void SessionLock::acquire(const std::filesystem::path& study) {
  if (descriptor_ < 0) descriptor_ = ::open(study.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor_ < 0)
    throw std::system_error(errno, std::generic_category(),
                            fmt::format("{}: cannot be read", study.string()));
  if (::flock(descriptor_, LOCK_EX | LOCK_NB) == 0) return;
  if (errno != EWOULDBLOCK)
    throw std::system_error(errno, std::generic_category(),
                            fmt::format("{}: cannot be locked", study.string()));
  throw std::runtime_error(
      fmt::format("{}: another palpate is leading a session in this study{}; wait for it, or stop it",
                  study.string(), told_holder(descriptor_)));
}

}  // namespace palpate::trials
