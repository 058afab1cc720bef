#include "base/files/read_file.hpp"

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>

#include "tests/support/temporary_folder.hpp"

namespace palpate::base {
namespace {

using testing::Eq;
using testing::ThrowsMessage;

TEST(ReadFile, GivesEveryByte) {
  const palpate::test::TemporaryFolder folder;
  std::string bytes = "a\r\n";
  for (int i = 0; i < 200000; ++i) bytes += static_cast<char>(i % 256);
  std::ofstream(folder / "bytes", std::ios::binary) << bytes;
  EXPECT_EQ(read_file(folder / "bytes"), bytes);
  std::ofstream(folder / "empty");
  EXPECT_EQ(read_file(folder / "empty"), "");
}

TEST(ReadFile, SaysWhatIsThereInstead) {
  EXPECT_THAT([] { read_file("no/such"); },
              ThrowsMessage<std::invalid_argument>(Eq("no/such: no such file")));
  EXPECT_THAT([] { read_file("no/such.msh", "a mesh file"); },
              ThrowsMessage<std::invalid_argument>(Eq("no/such.msh: no such file, accepted: a mesh file")));
  EXPECT_THAT([] { read_file("/"); },
              ThrowsMessage<std::invalid_argument>(Eq("/: is a folder, accepted: a file")));
  EXPECT_THAT([] { read_file("/dev/zero"); },
              ThrowsMessage<std::invalid_argument>(Eq("/dev/zero: is a device, accepted: a file")));
}

}  // namespace
}  // namespace palpate::base
