#include "base/text/shard.hpp"

#include <gtest/gtest.h>

namespace palpate::base {
namespace {

TEST(Shard, IsPartKOfN) {
  EXPECT_EQ(parse_shard("2/4"), (Shard{2, 4}));
  EXPECT_EQ(parse_shard("1/1"), (Shard{1, 1}));
}

TEST(Shard, IsNothingElse) {
  for (const char* text : {"", "2", "/", "0/4", "5/4", "-1/4", "2/4/8", "a/b", "2 /4", "2/4 ", "1.0/2", "2/"})
    EXPECT_FALSE(parse_shard(text)) << text;
}

}  // namespace
}  // namespace palpate::base
