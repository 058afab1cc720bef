#pragma once

#include <filesystem>

namespace palpate::trials {

/// One program at a time leads sessions in a study: flock on the study file itself. It ends with the process,
/// however that dies, and leaves no file. flock does not meet SQLite's own locks (fcntl), but closing any
/// descriptor of the file drops those: so an object of this class must outlive the database connection, and
/// keeps its descriptor even when the lock was refused.
class SessionLock {
 public:
  SessionLock() = default;
  ~SessionLock();
  SessionLock(const SessionLock&) = delete;
  SessionLock& operator=(const SessionLock&) = delete;

  /// Takes the lock, unless it is held already. Throws std::runtime_error when another program has it.
  void acquire(const std::filesystem::path& study);

 private:
  int descriptor_ = -1;
};

}  // namespace palpate::trials
