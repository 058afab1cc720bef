#include "base/files/new_folder.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <stdio.h>
#include <unistd.h>

#include <cerrno>
#include <stdexcept>
#include <system_error>
#include <vector>

#include "base/files/file_error.hpp"
#include "base/files/folder_of.hpp"

namespace palpate::base {
namespace fs = std::filesystem;
namespace {

[[noreturn]] void refuse_taken(const fs::path& path) {
  throw std::invalid_argument(
      fmt::format("{}: is there already and is not overwritten; accepted: another name", path.string()));
}

fs::path made_aside(const fs::path& beside) {
  for (int i = 0; i < 1000; ++i) {
    fs::path aside = fmt::format("{}.new-{}-{}", beside.string(), ::getpid(), i);
    std::error_code error;
    if (fs::create_directory(aside, error)) return aside;
    if (error && error != std::errc::file_exists) throw_cannot(error.value(), "make a folder there", beside);
  }
  throw_cannot(EEXIST, "make a folder there", beside);
}

/// The shortest part of `path` that does not exist.
fs::path first_missing(const fs::path& path) {
  fs::path missing = path;
  while (missing.has_parent_path() && missing.parent_path() != missing && !fs::exists(missing.parent_path()))
    missing = missing.parent_path();
  return missing;
}

void write_file(const fs::path& file, std::string_view bytes) {
  const int descriptor = ::open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (descriptor < 0) throw_cannot(errno, "create", file);
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) {
      const int why = errno;
      ::close(descriptor);
      throw_cannot(why, "write", file);
    }
    bytes.remove_prefix(written);
  }
  if (::close(descriptor) != 0) throw_cannot(errno, "write", file);
}

/// One call for the whole file system: a flush for each of thousands of files takes minutes.
void flush(const fs::path& folder) {
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) throw_cannot(errno, "open", folder);
  const int failed = ::syncfs(descriptor) == 0 ? 0 : errno;
  ::close(descriptor);
  if (failed != 0) throw_cannot(failed, "write", folder);
}

}  // namespace

void rename_new(const fs::path& from, const fs::path& to) {
  if (::renameat2(AT_FDCWD, from.c_str(), AT_FDCWD, to.c_str(), RENAME_NOREPLACE) == 0) return;
  const int why = errno;
  if (why == EEXIST) refuse_taken(to);
  // Some file systems know no such rename; then the look and the rename are two steps.
  if (why == EINVAL && fs::exists(fs::symlink_status(to))) refuse_taken(to);
  if (why == EINVAL && ::rename(from.c_str(), to.c_str()) == 0) return;
  throw_cannot(why, "be made", to);
}

NewFolder::NewFolder(fs::path folder, Beside beside) : folder_(std::move(folder)) {
  if (!folder_.has_filename()) folder_ = folder_.parent_path();  // "out/"
  if (fs::exists(folder_)) {
    if (!fs::is_directory(folder_)) refuse_taken(folder_);
    into_existing_ = beside == Beside::Others;
    if (!into_existing_ && !fs::is_empty(folder_)) refuse_taken(folder_);
    top_ = folder_;
    aside_ = made_aside(into_existing_ ? folder_ / "export" : fs::canonical(folder_));
    files_ = aside_;
    return;
  }
  top_ = first_missing(folder_);
  require_folder_of(top_);
  aside_ = made_aside(top_);
  const fs::path within = folder_.lexically_relative(top_);
  files_ = within == "." ? aside_ : aside_ / within;
  fs::create_directories(files_);
}

NewFolder::~NewFolder() {
  std::error_code ignored;
  if (!finished_ || into_existing_) fs::remove_all(aside_, ignored);
}

fs::path NewFolder::place(const fs::path& relative) const {
  fs::path file = files_ / relative;
  fs::create_directories(file.parent_path());
  return file;
}

void NewFolder::add(const fs::path& relative, std::string_view bytes) {
  write_file(place(relative), bytes);
  added_.push_back(relative);
}

/// Into a folder that holds other files; what was moved is taken back when one name is taken.
void NewFolder::move_each() const {
  std::vector<fs::path> moved;
  try {
    for (const fs::path& file : added_) {
      rename_new(files_ / file, folder_ / file);
      moved.push_back(folder_ / file);
    }
  } catch (...) {
    std::error_code ignored;
    for (const fs::path& file : moved) fs::remove(file, ignored);
    throw;
  }
}

void NewFolder::finish() {
  flush(files_);
  if (into_existing_) {
    move_each();
  } else if (top_ == folder_ && fs::exists(folder_)) {
    // A folder takes the place of an empty folder, and of nothing else.
    if (::rename(aside_.c_str(), fs::canonical(folder_).c_str()) != 0) {
      if (errno == ENOTEMPTY || errno == EEXIST || errno == ENOTDIR) refuse_taken(folder_);
      throw_cannot(errno, "be made", folder_);
    }
  } else {
    rename_new(aside_, top_);
  }
  finished_ = true;
}

}  // namespace palpate::base
