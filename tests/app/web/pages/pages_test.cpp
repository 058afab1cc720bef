#include "app/web/pages/pages.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <regex>
#include <set>
#include <stdexcept>
#include <string>

namespace palpate::app {
namespace {

using testing::Contains;
using testing::Field;
using testing::Not;
using testing::SizeIs;

/// What an HTML page loads: its src and href attributes.
std::set<std::string> loaded_by(const PageFile& html) {
  const std::string text(html.bytes);
  const std::regex attribute("(?:src|href)=\"([^\"]+)\"");
  std::set<std::string> files;
  for (std::sregex_iterator at(text.begin(), text.end(), attribute), end; at != end; ++at)
    files.insert((*at)[1].str());
  return files;
}

TEST(Pages, TheExamineesIsOneOfThem) {
  EXPECT_EQ(page("examinee").name, "examinee");
  EXPECT_THROW(page("nobody's"), std::logic_error);
}

TEST(Pages, HaveNamesOfTheirOwn) {
  std::set<std::string_view> names;
  for (const Page& page : pages()) names.insert(page.name);
  EXPECT_THAT(names, SizeIs(pages().size()));
  EXPECT_THAT(names, Not(Contains("shared")));
}

TEST(Pages, HoldEveryFileThatTheyLoad) {
  for (const Page& page : pages()) {
    const auto html = std::ranges::find(page.files, "index.html", &PageFile::name);
    ASSERT_NE(html, page.files.end()) << page.name;
    const std::set<std::string> wanted = loaded_by(*html);
    EXPECT_THAT(wanted, Contains("page.js")) << page.name;
    for (const std::string& file : wanted)
      EXPECT_THAT(page.files, Contains(Field(&PageFile::name, file))) << page.name;
  }
}

TEST(Pages, NoFileIsEmpty) {
  for (const Page& page : pages())
    for (const PageFile& file : page.files) EXPECT_THAT(file.bytes, Not(SizeIs(0))) << page.name << file.name;
}

}  // namespace
}  // namespace palpate::app
