#include "app/number_column.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "app/parse_number.hpp"

using namespace palpate::app;
using testing::ElementsAre;
using testing::HasSubstr;

namespace {

class NumberColumn : public testing::Test {
 protected:
  void TearDown() override { std::filesystem::remove(file_); }

  std::vector<double> read(const std::string& text) {
    std::ofstream(file_, std::ios::binary) << text;
    return read_number_column(file_);
  }

  std::string refusal(const std::string& text) {
    try {
      read(text);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "nothing thrown";
  }

  const std::filesystem::path file_ =
      std::filesystem::temp_directory_path() /
      ("palpate_" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()) + ".csv");
};

}  // namespace

TEST_F(NumberColumn, ReadsWhatOtherProgramsWrite) {
  EXPECT_THAT(read("1\n-2.5\n+3e-2\n"), ElementsAre(1, -2.5, 0.03));
  EXPECT_THAT(read("difference\r\n1\r\n2\r\n"), ElementsAre(1, 2));
  EXPECT_THAT(read("\xEF\xBB\xBF\"difference\"\n\"1\"\n 2 \n\n\n"), ElementsAre(1, 2));
  EXPECT_THAT(read("4"), ElementsAre(4));  // no line end
}

TEST_F(NumberColumn, NamesTheLineOfWhatItRefuses) {
  EXPECT_THAT(refusal("d\n1\ntwo\n"), HasSubstr(".csv:3: 'two' is no finite number"));
  EXPECT_THAT(refusal("1,5\n2,5\n"), HasSubstr(".csv:1: '1,5' is more than one column"));
  EXPECT_THAT(refusal("a,b\n1,2\n"), HasSubstr(".csv:1: 'a,b' is more than one column"));
  EXPECT_THAT(refusal("1\n\n2\n"), HasSubstr(".csv:2: the line is blank"));
  EXPECT_THAT(refusal("1\nnan\n"), HasSubstr(".csv:2: 'nan' is no finite number"));
  EXPECT_THAT(refusal("1\n1e999\n"), HasSubstr(".csv:2: '1e999' is no finite number"));
  EXPECT_THAT(refusal("n/a\n1\n"),
              HasSubstr(".csv:1: 'n/a' is no finite number"));  // a missing value, no header
  EXPECT_THAT(refusal("-inf\n1\n"), HasSubstr(".csv:1: '-inf' is no finite number"));
  EXPECT_THAT(refusal("header\n"), HasSubstr("no numbers"));
  EXPECT_THAT(refusal(""), HasSubstr("no numbers"));
}

TEST_F(NumberColumn, RefusesWhatIsNoFile) {
  EXPECT_THROW(read_number_column("/nonexistent/differences.csv"), std::invalid_argument);
  EXPECT_THROW(read_number_column(std::filesystem::temp_directory_path()), std::invalid_argument);
}

TEST(ParseNumber, TakesFractionsAndDecimals) {
  EXPECT_EQ(parse_fraction("--chance", "1/2"), 0.5);
  EXPECT_EQ(parse_fraction("--chance", "0.25"), 0.25);
  for (const char* wrong : {"", "1/", "/2", "1/0", "half", "1/2/3", "0,5", "1/2 ", "nan"}) {
    EXPECT_THROW(parse_fraction("--chance", wrong), std::invalid_argument) << wrong;
  }
}

TEST(ParseNumber, CountsTheCounts) {
  EXPECT_THAT(parse_counts("--table", "794,86,150,570", 4), ElementsAre(794, 86, 150, 570));
  for (const char* wrong :
       {"", "1,2,3", "1,2,3,4,5", "1,2,3,", "1,2,3,x", "1.5,2,3,4", "99999999999999999999,1,1,1"}) {
    EXPECT_THROW(parse_counts("--table", wrong, 4), std::invalid_argument) << wrong;
  }
}
