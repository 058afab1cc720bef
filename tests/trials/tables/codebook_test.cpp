#include "trials/tables/codebook.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>

#include "tests/trials/support/protocols.hpp"
#include "trials/export/check_values.hpp"

namespace palpate::trials {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::vector<std::string> problems_of(const Table& table) {
  std::vector<std::string> problems;
  check_table(table, problems);
  return problems;
}

TEST(Codebook, SaysOneNameInTheSameWordsInEveryTable) {
  const Protocol protocol = test::small_protocol();
  std::map<std::string, std::string> said;
  for (const auto& columns :
       {trial_columns(protocol), interval_columns(protocol), exposure_columns(protocol)})
    for (const Column& column : columns) {
      const auto [first, is_new] = said.emplace(column.name, column.description + column.unit);
      EXPECT_EQ(first->second, column.description + column.unit) << column.name;
    }
}

TEST(Codebook, DescribesEveryColumnWell) {
  const Protocol protocol = test::small_protocol();
  EXPECT_THAT(problems_of({.name = "t", .columns = trial_columns(protocol)}), IsEmpty());
  EXPECT_THAT(problems_of({.name = "i", .columns = interval_columns(protocol)}), IsEmpty());
  EXPECT_THAT(problems_of({.name = "e", .columns = exposure_columns(protocol)}), IsEmpty());
}

TEST(Codebook, TellsWhatTheConditionsAndFactorsMean) {
  const Protocol protocol = test::small_protocol();
  for (const Column& column : interval_columns(protocol))
    if (column.name == "condition") {
      ASSERT_EQ(column.levels.size(), 2U);
      EXPECT_EQ(column.levels[1].value, "hard");
      EXPECT_THAT(column.levels[1].meaning, HasSubstr("bodies.prostate.young_modulus"));
    }
  for (const Column& column : trial_columns(protocol))
    if (column.name == "contact_model") {
      EXPECT_EQ(pattern_of(column), "kuroda|sibille");
    }
}

TEST(Codebook, EveryValueIsHeldAgainstIt) {
  const Column number{.name = "x_s",
                      .title = "x",
                      .description = "x",
                      .unit = "s",
                      .kind = Kind::Real,
                      .least = 0,
                      .most = 1};
  const Column count{
      .name = "n", .title = "n", .description = "n", .kind = Kind::Whole, .may_be_missing = true};
  const Column word{.name = "w", .title = "w", .description = "w", .levels = {{"a.b", "one"}, {"c", "two"}}};
  const Table good{.name = "t",
                   .columns = {number, count, word},
                   .rows = {{0.5, std::int64_t{2}, std::string("a.b")}, {1.0, Value(), std::string("c")}}};
  EXPECT_THAT(problems_of(good), IsEmpty());
  const auto with_row = [&](std::vector<Value> row) {
    Table bad = good;
    bad.rows.push_back(std::move(row));
    return problems_of(bad);
  };
  EXPECT_THAT(with_row({1.5, Value(), std::string("c")}),
              ElementsAre("t: column x_s, row 3: \"1.5\" is out of range"));
  EXPECT_THAT(with_row({Value(), Value(), std::string("c")}), ElementsAre(HasSubstr("\"n/a\" is missing")));
  EXPECT_THAT(with_row({0.0 / 0.0, Value(), std::string("c")}), ElementsAre(HasSubstr("is no number")));
  EXPECT_THAT(with_row({0.5, 2.5, std::string("c")}), ElementsAre(HasSubstr("is no whole number")));
  EXPECT_THAT(with_row({0.5, Value(), std::string("axb")}), ElementsAre(HasSubstr("pattern or levels")));
  EXPECT_THAT(with_row({0.5, Value()}), ElementsAre(HasSubstr("a row has 2 cells of 3")));
}

TEST(Codebook, ANameSaysItsUnit) {
  EXPECT_THAT(
      problems_of(
          {.name = "t",
           .columns =
               {{.name = "force", .title = "f", .description = "f", .unit = "N", .kind = Kind::Real}}}),
      ElementsAre(HasSubstr("has the unit \"N\" and a name that says \"\"")));
}

}  // namespace
}  // namespace palpate::trials
