#include "app/web/host/kept_link.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "app/web/server/access.hpp"
#include "tests/support/temporary_folder.hpp"

namespace palpate::app {
namespace {

TEST(KeptLink, IsReadBackByItsOwnerAlone) {
  const test::TemporaryFolder folder;
  const auto file = kept_link_file(folder / "study.db");
  EXPECT_EQ(file.filename(), "study.db.page");
  EXPECT_FALSE(read_kept_link(file));
  const std::string token = draw_token();
  keep_link(file, {.sitting = "P01 study", .port = 4711, .token = token});
  EXPECT_EQ(std::filesystem::status(file).permissions(), std::filesystem::perms(0600));
  const auto kept = read_kept_link(file);
  ASSERT_TRUE(kept);
  EXPECT_EQ(kept->sitting, "P01 study");
  EXPECT_EQ(kept->port, 4711);
  EXPECT_EQ(kept->token, token);
}

TEST(KeptLink, ThatIsDamagedIsNone) {
  const test::TemporaryFolder folder;
  for (const std::string text : {"", "4711", "4711 abc P01 study\n", "x y z\n", "99999999 0 P01\n"}) {
    std::ofstream(folder / "study.db.page") << text;
    EXPECT_FALSE(read_kept_link(folder / "study.db.page")) << text;
  }
}

}  // namespace
}  // namespace palpate::app
