#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace palpate::base {

/// Gives a file or folder its name and never replaces what stands there. Throws std::invalid_argument when
/// the name is taken, std::system_error when the disk refuses.
void rename_new(const std::filesystem::path& from, const std::filesystem::path& to);

/// Files that appear together or not at all: they are written aside, on the same disk, and finish() gives
/// them their place. Nothing that stands there is ever replaced, and nothing stays when finish() is not
/// reached.
class NewFolder {
 public:
  /// What may already stand at the folder's place. Nothing: the folder is missing or empty. Others: the files
  /// that add() wrote, none of them in a folder below, are put beside those that are there.
  enum class Beside { Nothing, Others };

  /// Throws std::invalid_argument when the place is taken, std::system_error when the disk refuses.
  NewFolder(std::filesystem::path folder, Beside beside);
  ~NewFolder();
  NewFolder(const NewFolder&) = delete;
  NewFolder& operator=(const NewFolder&) = delete;

  /// Where a file is written until finish(); the folders above it are made.
  std::filesystem::path place(const std::filesystem::path& relative) const;
  void add(const std::filesystem::path& relative, std::string_view bytes);

  /// The folder as it will be.
  const std::filesystem::path& aside() const { return files_; }

  /// Flushes everything to the disk and gives it its place.
  void finish();

 private:
  void move_each() const;

  std::filesystem::path folder_;  // asked for
  std::filesystem::path top_;     // the first part of it that is not there yet, or all of it
  std::filesystem::path aside_;   // becomes top_
  std::filesystem::path files_;   // within aside_: becomes folder_
  std::vector<std::filesystem::path> added_{};
  bool into_existing_ = false;
  bool finished_ = false;
};

}  // namespace palpate::base
