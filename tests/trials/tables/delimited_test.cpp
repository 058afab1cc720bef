#include "trials/tables/delimited.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>

namespace palpate::trials {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// Text of what troubles readers: quotes, commas, backslashes, control characters, bytes that are not UTF-8.
rc::Gen<std::string> awkward_text() {
  return rc::gen::container<std::string>(rc::gen::oneOf(
      rc::gen::elementOf(std::string("\"\\,;\t\n\r'n/a \xC3\xA9\xFF\x80")), rc::gen::arbitrary<char>()));
}

Table table_of(const std::vector<std::pair<std::string, std::string>>& rows) {
  Table table{.name = "t", .columns = {{.name = "a"}, {.name = "b"}}};
  for (const auto& [a, b] : rows) table.rows.push_back({plain_text(a), plain_text(b)});
  return table;
}

TEST(Delimited, WhateverIsWrittenIsReadBack) {
  const bool holds = rc::check("CSV", [] {
    const auto rows = *rc::gen::container<std::vector<std::pair<std::string, std::string>>>(
        rc::gen::pair(awkward_text(), awkward_text()));
    const Table table = table_of(rows);
    std::vector<std::string> problems;
    const StrictTable back = read_strictly(to_csv(table), ',', "t", problems);
    RC_ASSERT(problems.empty());
    RC_ASSERT(back.rows.size() == rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i)
      for (std::size_t c = 0; c < 2; ++c) RC_ASSERT(back.rows[i][c] == cell_text(table.rows[i][c]));
    read_strictly(to_tsv(table), '\t', "t", problems);
    RC_ASSERT(problems.empty());
  });
  EXPECT_TRUE(holds);
}

TEST(Delimited, NumbersHaveAllTheirDigits) {
  const Table table{.name = "t", .columns = {{.name = "a"}, {.name = "b"}}, .rows = {{0.1 + 0.2, Value()}}};
  EXPECT_EQ(to_csv(table), "a,b\n0.30000000000000004,n/a\n");
  EXPECT_EQ(to_tsv(table), "a\tb\n0.30000000000000004\tn/a\n");
}

TEST(Delimited, PlainTextKeepsWhatItCan) {
  EXPECT_EQ(plain_text("caf\xC3\xA9 \xE2\x82\xAC"), "caf\xC3\xA9 \xE2\x82\xAC");
  EXPECT_EQ(plain_text("a\tb\nc"), "a b c");
  EXPECT_EQ(plain_text("\xC0\x80"), "\xEF\xBF\xBD\xEF\xBF\xBD");       // an overlong null
  EXPECT_EQ(plain_text("\xED\xA0\x80").substr(0, 3), "\xEF\xBF\xBD");  // a surrogate
  EXPECT_EQ(plain_text("a\xE2\x82"), "a\xEF\xBF\xBD\xEF\xBF\xBD");     // cut short
  EXPECT_EQ(plain_text("\\\"x\\"), "\\ \"x\\ ");
}

TEST(Delimited, TellsTheLineOfWhatIsWrong) {
  std::vector<std::string> problems;
  read_strictly("a,b\n1,2\n3\n", ',', "file.csv", problems);
  EXPECT_THAT(problems, ElementsAre("file.csv:3: has 1 cells of 2"));
  problems.clear();
  read_strictly("a,b\n\"x\"y,2\n", ',', "file.csv", problems);
  EXPECT_THAT(problems, testing::Contains(HasSubstr("file.csv:2: a quote stands in the wrong place")));
  problems.clear();
  read_strictly("a,b\n1,\"2\n", ',', "file.csv", problems);
  EXPECT_THAT(problems, testing::Contains(HasSubstr("a quote stands in the wrong place")));
  problems.clear();
  read_strictly("", ',', "file.csv", problems);
  EXPECT_THAT(problems, Not(IsEmpty()));
}

}  // namespace
}  // namespace palpate::trials
