#include "app/commands/stats/read_csv.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>

using namespace palpate::app;
using palpate::analysis::DataTable;
using palpate::analysis::number_column;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

namespace {

class ReadCsv : public testing::Test {
 protected:
  void TearDown() override { std::filesystem::remove(file_); }

  DataTable read(const std::string& text) {
    std::ofstream(file_, std::ios::binary) << text;
    return read_csv(file_);
  }

  std::string refusal(const std::string& text) {
    try {
      number_column(read(text), "difference");
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

TEST_F(ReadCsv, ReadsWhatOtherProgramsWrite) {
  const auto differences = [this](const std::string& text) {
    return number_column(read(text), "difference");
  };
  EXPECT_THAT(differences("1\n-2.5\n+3e-2\n"), ElementsAre(1, -2.5, 0.03));
  EXPECT_THAT(differences("difference\r\n1\r\n2\r\n"), ElementsAre(1, 2));
  EXPECT_THAT(differences("\xEF\xBB\xBF\"difference\"\n\"1\"\n 2 \n\n\n"), ElementsAre(1, 2));
  EXPECT_THAT(differences("4"), ElementsAre(4));  // no line end
  EXPECT_THAT(differences("examinee,difference\nP01,4\nP02,-1\n"), ElementsAre(4, -1));
}

TEST_F(ReadCsv, KeepsCommasQuotesAndLineBreaksWithinQuotes) {
  const DataTable table = read("name,note\n\n\"a, b\",\"said \"\"no\"\"\"\n\"two\nlines\",x\nlast,y\n");
  EXPECT_THAT(table.names, ElementsAre("name", "note"));
  EXPECT_THAT(table.columns[0], ElementsAre("a, b", "two\nlines", "last"));
  EXPECT_THAT(table.columns[1], ElementsAre("said \"no\"", "x", "y"));
  EXPECT_THAT(table.lines, ElementsAre(3, 4, 6));
}

TEST_F(ReadCsv, TakesALineOfNumbersForData) {
  const DataTable table = read("1,2\n3,4\n");
  EXPECT_THAT(table.names, IsEmpty());
  EXPECT_THAT(table.columns[1], ElementsAre("2", "4"));
}

TEST_F(ReadCsv, TellsThatTheFirstLineWasTakenForData) {
  const std::string text = "1,5,10\n2.1,2.6,3.0\n1.8,2.0,2.4\n";
  const DataTable guessed = read(text);
  ASSERT_EQ(guessed.notes.size(), 1U);
  EXPECT_THAT(guessed.notes[0],
              HasSubstr("line 1 was taken as data (no header), since '1' (column 1) is a number; --header"));
  const DataTable names = read_csv(file_, FirstLine::Names);
  EXPECT_THAT(names.names, ElementsAre("1", "5", "10"));
  EXPECT_THAT(names.columns[0], ElementsAre("2.1", "1.8"));
  EXPECT_THAT(names.notes, IsEmpty());
  const DataTable data = read_csv(file_, FirstLine::Data);
  EXPECT_THAT(data.columns[0], ElementsAre("1", "2.1", "1.8"));
  EXPECT_THAT(data.notes, IsEmpty());
  EXPECT_THAT(read("examinee,level\nP1,1\n").notes, IsEmpty());
}

TEST_F(ReadCsv, SaysWhyTheFirstLineNamesNothing) {
  const auto of_matrix = [this](const std::string& text) -> std::string {
    try {
      palpate::analysis::number_columns(read(text));
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "nothing thrown";
  };
  EXPECT_THAT(of_matrix("examinee,1,5\nP1,2.1,2.6\n"),
              HasSubstr(".csv:1: column 1 is 'examinee'; accepted: a finite number"));
  EXPECT_THAT(
      of_matrix("examinee,1,5\nP1,2.1,2.6\n"),
      HasSubstr("line 1 was not taken as a header: '1' (column 2) is a number (--header takes it as one)"));
  EXPECT_THAT(refusal("a,n/a\n1,2\n"), HasSubstr("'n/a' (column 2) stands for a number"));
}

TEST_F(ReadCsv, OnlyWholeWordsStandForNumbers) {
  EXPECT_THAT(read("difference,informed_consent\n1,yes\n").names,
              ElementsAre("difference", "informed_consent"));
  EXPECT_THAT(read("information,nano,-information\n1,yes,2\n").notes, IsEmpty());
  for (const char* word : {"inf", "-Infinity", "+INF", "NaN", "na", "infinity"})
    EXPECT_THAT(read(std::string("difference,") + word + "\n1,2\n").names, IsEmpty()) << word;
}

TEST_F(ReadCsv, AColumnWithoutANameIsNamedByItsPlace) {
  const DataTable indexed = read("\"\",difference\n0,3\n1,1\n2,-2\n");  // as pandas and R write them
  EXPECT_THAT(indexed.names, ElementsAre("difference"));
  EXPECT_THAT(number_column(indexed, "difference"), ElementsAre(3, 1, -2));
  ASSERT_EQ(indexed.notes.size(), 1U);
  EXPECT_THAT(indexed.notes[0], HasSubstr("the first column has no name and holds running numbers"));
  EXPECT_THAT(refusal(",difference\n3,3\n1,1\n"),
              HasSubstr(".csv:1: column 1 has an empty name; accepted: a name"));
  EXPECT_THAT(refusal("difference,trials,\n1,2,\n"),
              HasSubstr(".csv:1: column 3 has an empty name and no values (a comma at the end of a line"));
}

TEST_F(ReadCsv, NamesWhatSpreadsheetsOfOtherLanguagesWrite) {
  EXPECT_THAT(
      refusal("level;difference\n0,5;26\n"),
      HasSubstr(".csv:2: 2 fields; the first line has 1; the columns seem to be separated by ';', and "
                "numbers may have a decimal comma"));
  EXPECT_THAT(refusal("\"level\";\"difference\"\n0,5;26\n"), HasSubstr("separated by commas, not by ';'"));
  EXPECT_THAT(refusal("sep=;\nlevel;difference\n"), HasSubstr(".csv:1: 'sep=;' is a spreadsheet's note"));
  EXPECT_THAT(refusal("# made by a script\nlevel,difference\n1,2\n"),
              HasSubstr(".csv:2: 2 fields; the first line has 1; line 1 looks like a comment"));
}

TEST_F(ReadCsv, NamesTheLineOfWhatItRefuses) {
  EXPECT_THAT(refusal("difference\n1\ntwo\n"), HasSubstr(".csv:3: difference is 'two'; accepted: a finite"));
  EXPECT_THAT(refusal("1,5\n2,5\n"),
              HasSubstr("no column 'difference': the file has 2 columns and no header"));
  EXPECT_THAT(refusal("a,b\n1,2\n"), HasSubstr("no column 'difference'; there is a and b"));
  EXPECT_THAT(refusal("a,b\n1,2,3\n"), HasSubstr(".csv:2: 3 fields; the first line has 2"));
  EXPECT_THAT(refusal("a,a\n1,2\n"), HasSubstr(".csv:1: the column 'a' is there twice"));
  EXPECT_THAT(refusal("a\nx\"y\"\n"), HasSubstr(".csv:2: a quote in the middle of a field"));
  EXPECT_THAT(refusal("a\n\"x\n"), HasSubstr("the file ends within quotes"));
  EXPECT_THAT(refusal("1\nnan\n"), HasSubstr(".csv:2: the value is 'nan'"));
  EXPECT_THAT(refusal("1\n1e999\n"), HasSubstr(".csv:2: the value is '1e999'"));
  EXPECT_THAT(refusal("n/a\n1\n"), HasSubstr(".csv:1: the value is 'n/a'"));  // a missing value, no header
  EXPECT_THAT(refusal("-inf\n1\n"), HasSubstr(".csv:1: the value is '-inf'"));
  EXPECT_THAT(refusal("header\n"), HasSubstr("no rows of data"));
  EXPECT_THAT(refusal(""), HasSubstr("no rows of data"));
}

TEST_F(ReadCsv, RefusesTextThatIsNoUtf8AndNamesTheSeparator) {
  EXPECT_THAT(refusal("difference,name\n1,\xC3\xA9\n2,caf\xE9\n"),
              HasSubstr(".csv:3: a byte that is no UTF-8"));
  EXPECT_THAT(refusal("\xFF\xFE"
                      "1\n"),
              HasSubstr(".csv:1: a byte that is no UTF-8"));
  EXPECT_THAT(refusal("difference;x\n1;2\n"), HasSubstr("; columns are separated by commas"));
  EXPECT_THAT(refusal("1e400\n1\n"), HasSubstr(".csv:1: the value is '1e400'"));  // data, no header
}

TEST_F(ReadCsv, RefusesWhatIsNoFile) {
  EXPECT_THROW(read_csv("/nonexistent/differences.csv"), std::invalid_argument);
  EXPECT_THROW(read_csv(std::filesystem::temp_directory_path()), std::invalid_argument);
}
