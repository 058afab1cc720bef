#include "trials/study/examinee_code.hpp"

#include <gtest/gtest.h>

#include <stdexcept>
#include <vector>

namespace palpate::trials {
namespace {

TEST(ExamineeCode, IsLettersDigitsAndHyphens) {
  for (const char* code : {"P01", "a", "control-7", "12345678901234567890123456789012"})
    EXPECT_NO_THROW(check_examinee_code(code)) << code;
  for (const char* code : {"", "-P01", "--no-browser", "Ms Jones", "P_1", "M\xC3\xBCller", "../x",
                           "123456789012345678901234567890123"})
    EXPECT_THROW(check_examinee_code(code), std::invalid_argument) << code;
}

TEST(ExamineeCode, NearOnesShareANormalForm) {
  for (const char* code : {"P1", "p1", "P01", "p-001", "P0001"}) EXPECT_EQ(normal_form(code), "p1") << code;
  EXPECT_EQ(normal_form("P10"), "p10");
  EXPECT_EQ(normal_form("P0"), "p0");
  EXPECT_EQ(normal_form("P00"), "p0");
  EXPECT_EQ(normal_form("P100"), "p100");
  EXPECT_EQ(normal_form("A02B03"), "a2b3");
}

TEST(ExamineeCode, OneNearToAnotherIsRefused) {
  const std::vector<std::string> known{"P01", "P02"};
  EXPECT_NO_THROW(check_not_near("P01", known));
  EXPECT_NO_THROW(check_not_near("P11", known));
  EXPECT_THROW(check_not_near("P1", known), std::invalid_argument);
  EXPECT_THROW(check_not_near("p02", known), std::invalid_argument);
}

}  // namespace
}  // namespace palpate::trials
