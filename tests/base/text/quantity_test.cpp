#include "base/text/quantity.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>
#include <stdexcept>

namespace palpate::base {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

TEST(Quantity, ReadsEachUnitInSi) {
  EXPECT_DOUBLE_EQ(parse_quantity("5 mm", Dimension::Length), 0.005);
  EXPECT_DOUBLE_EQ(parse_quantity(" 1.5e1cm ", Dimension::Length), 0.15);
  EXPECT_DOUBLE_EQ(parse_quantity("1.0 MPa", Dimension::Pressure), 1e6);
  EXPECT_DOUBLE_EQ(parse_quantity("90 deg", Dimension::Angle), std::numbers::pi / 2);
  EXPECT_DOUBLE_EQ(parse_quantity("-3 N", Dimension::Force), -3.0);
}

TEST(Quantity, RefusesAMissingUnit) {
  EXPECT_THAT([] { parse_quantity("5", Dimension::Length); },
              ThrowsMessage<std::invalid_argument>(AllOf(HasSubstr("no unit"), HasSubstr("mm"))));
}

TEST(Quantity, RefusesTheUnitOfAnotherDimension) {
  EXPECT_THAT(
      [] { parse_quantity("5 MPa", Dimension::Length); },
      ThrowsMessage<std::invalid_argument>(AllOf(HasSubstr("\"MPa\""), HasSubstr("accepted units: m, cm"))));
}

TEST(Quantity, RefusesWhatIsNoFiniteNumber) {
  for (const char* text : {"", "mm", "1,5 mm", "nan mm", "inf mm", "1e999 mm", "0x10 mm", "5 mm mm"})
    EXPECT_THROW(parse_quantity(text, Dimension::Length), std::invalid_argument) << text;
}

}  // namespace
}  // namespace palpate::base
