#include "base/text/csv.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gmock/gmock.h>
#include <rapidcheck.h>

namespace palpate::base {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::ThrowsMessage;

TEST(Csv, RowsKnowTheLineTheyBeginOn) {
  const auto rows = split_csv(
      "\xEF\xBB\xBF"
      "a,b\r\n\n\"x\ny\",2\n3,4",
      "file.csv");
  ASSERT_EQ(rows.size(), 3U);
  EXPECT_THAT(rows[0].fields, ElementsAre("a", "b"));
  EXPECT_THAT(rows[1].fields, ElementsAre("x\ny", "2"));
  EXPECT_THAT(rows[2].fields, ElementsAre("3", "4"));
  EXPECT_EQ(rows[0].line, 1);
  EXPECT_EQ(rows[1].line, 3);
  EXPECT_EQ(rows[2].line, 5);
}

TEST(Csv, SaysWhereATextIsNone) {
  EXPECT_THAT(
      [] { split_csv("a,b\n1,2\"3\n", "file.csv"); },
      ThrowsMessage<std::invalid_argument>(HasSubstr("file.csv:2: a quote in the middle of a field")));
  EXPECT_THAT([] { split_csv("a\n\"b\n", "file.csv"); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("file.csv:2: the file ends within quotes")));
  EXPECT_THAT([] { split_csv("a\nb\xFF\n", "file.csv"); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("file.csv:2: a byte that is no UTF-8")));
}

// Any fields, quoted as RFC 4180 has it, come back as they were.
TEST(Csv, GivesBackWhatWasQuoted) {
  rc::check([] {
    const auto field = rc::gen::container<std::string>(rc::gen::element('a', ',', '"', '\n', ' ', '7'));
    const auto row = *rc::gen::container<std::vector<std::string>>(3, field);
    std::vector<std::string> quoted;
    for (const std::string& value : row) {
      std::string doubled;
      for (const char c : value) doubled += c == '"' ? std::string("\"\"") : std::string(1, c);
      quoted.push_back(fmt::format("\"{}\"", doubled));
    }
    const auto rows = split_csv(fmt::format("{}\n", fmt::join(quoted, ",")), "file.csv");
    RC_ASSERT(rows.size() == 1U);
    RC_ASSERT(rows[0].fields == row);
  });
}

}  // namespace
}  // namespace palpate::base
