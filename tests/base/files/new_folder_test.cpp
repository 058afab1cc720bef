#include "base/files/new_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <system_error>

#include "tests/support/temporary_folder.hpp"

namespace palpate::base {
namespace {

namespace fs = std::filesystem;
using Beside = NewFolder::Beside;

std::string read(const fs::path& file) {
  std::ifstream stream(file);
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::size_t entries(const fs::path& folder) {
  return std::distance(fs::directory_iterator(folder), {});
}

class NewFolderTest : public testing::Test {
 protected:
  palpate::test::TemporaryFolder temporary_;
  fs::path root_ = temporary_.path();
};

TEST_F(NewFolderTest, AppearsWholeAtTheEnd) {
  NewFolder folder(root_ / "a/b/c", Beside::Nothing);
  folder.add("x/y.txt", "text");
  EXPECT_FALSE(fs::exists(root_ / "a"));
  folder.finish();
  EXPECT_EQ(read(root_ / "a/b/c/x/y.txt"), "text");
  EXPECT_EQ(entries(root_), 1U);
}

TEST_F(NewFolderTest, LeavesNothingWhenItIsNotFinished) {
  fs::create_directory(root_ / "empty");
  for (const char* name : {"a/b/c", "empty", "d/"}) {
    NewFolder folder(root_ / name, Beside::Nothing);
    folder.add("x/y.txt", "text");
  }
  EXPECT_EQ(entries(root_), 1U);
  EXPECT_TRUE(fs::is_empty(root_ / "empty"));
}

TEST_F(NewFolderTest, TakesThePlaceOfAnEmptyFolderOnly) {
  fs::create_directory(root_ / "out");
  NewFolder folder(root_ / "out/", Beside::Nothing);
  folder.add("mine.txt", "new");
  std::ofstream(root_ / "out/yours.txt") << "old";  // comes while it is written
  EXPECT_THROW(folder.finish(), std::invalid_argument);
  EXPECT_EQ(read(root_ / "out/yours.txt"), "old");
  EXPECT_EQ(entries(root_ / "out"), 1U);
  EXPECT_THROW(NewFolder(root_ / "out", Beside::Nothing), std::invalid_argument);
  fs::remove(root_ / "out/yours.txt");
  NewFolder second(root_ / "out", Beside::Nothing);
  second.add("mine.txt", "new");
  second.finish();
  EXPECT_EQ(read(root_ / "out/mine.txt"), "new");
}

TEST_F(NewFolderTest, ReplacesNothingThatCameMeanwhile) {
  NewFolder folder(root_ / "out", Beside::Nothing);
  folder.add("mine.txt", "new");
  std::ofstream(root_ / "out") << "old";
  EXPECT_THROW(folder.finish(), std::invalid_argument);
  EXPECT_EQ(read(root_ / "out"), "old");
}

TEST_F(NewFolderTest, PutsFilesBesideOthersAndTakesAllBackWhenOneNameIsTaken) {
  fs::create_directory(root_ / "out");
  std::ofstream(root_ / "out/b.txt") << "old";
  {
    NewFolder folder(root_ / "out", Beside::Others);
    for (const char* name : {"a.txt", "b.txt", "c.txt"}) folder.add(name, "new");
    EXPECT_THROW(folder.finish(), std::invalid_argument);
  }
  EXPECT_EQ(read(root_ / "out/b.txt"), "old");
  EXPECT_EQ(entries(root_ / "out"), 1U);
  NewFolder folder(root_ / "out", Beside::Others);
  folder.add("a.txt", "new");
  folder.finish();
  EXPECT_EQ(read(root_ / "out/a.txt"), "new");
}

TEST_F(NewFolderTest, SaysWhereNothingCanBeWritten) {
  std::ofstream(root_ / "file") << "text";
  EXPECT_THROW(NewFolder(root_ / "file", Beside::Others), std::invalid_argument);
  EXPECT_THROW(NewFolder("/proc/palpate/out", Beside::Nothing), std::system_error);
}

TEST_F(NewFolderTest, ARenameReplacesNothing) {
  std::ofstream(root_ / "a") << "a";
  std::ofstream(root_ / "b") << "b";
  EXPECT_THROW(rename_new(root_ / "a", root_ / "b"), std::invalid_argument);
  EXPECT_THROW(rename_new(root_ / "none", root_ / "c"), std::system_error);
  rename_new(root_ / "a", root_ / "c");
  EXPECT_EQ(read(root_ / "b") + read(root_ / "c"), "ba");
}

}  // namespace
}  // namespace palpate::base
