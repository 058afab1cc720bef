#include "base/files/atomic_file.hpp"

#include <gmock/gmock.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <system_error>

#include "base/files/read_file.hpp"
#include "tests/support/temporary_folder.hpp"

namespace palpate::base {
namespace {

int entries_of(const std::filesystem::path& folder) {
  return static_cast<int>(std::distance(std::filesystem::directory_iterator(folder), {}));
}

TEST(WriteTogether, PutsAllFilesInTheirPlaces) {
  const palpate::test::TemporaryFolder folder;
  std::ofstream(folder / "a") << "old";
  const std::array<FileText, 2> files{{{folder / "a", "new"}, {folder / "b", "also new"}}};
  write_together(files);
  EXPECT_EQ(read_file(folder / "a"), "new");
  EXPECT_EQ(read_file(folder / "b"), "also new");
  EXPECT_EQ(entries_of(folder.path()), 2);
}

TEST(WriteTogether, ChangesNothingWhereOneIsRefused) {
  const palpate::test::TemporaryFolder folder;
  std::ofstream(folder / "a") << "old";
  std::filesystem::create_directory(folder / "taken");
  const std::array<FileText, 2> into_folder{{{folder / "a", "new"}, {folder / "taken", "text"}}};
  EXPECT_THROW(write_together(into_folder), std::system_error);
  const std::array<FileText, 2> nowhere{{{folder / "a", "new"}, {folder / "none" / "b", "text"}}};
  EXPECT_THROW(write_together(nowhere), std::invalid_argument);
  EXPECT_EQ(read_file(folder / "a"), "old");
  EXPECT_EQ(entries_of(folder.path()), 2);
}

}  // namespace
}  // namespace palpate::base
