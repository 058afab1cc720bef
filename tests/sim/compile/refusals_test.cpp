// What compile() refuses of a scene whose single values are in order.
#include <gmock/gmock.h>

#include <string>
#include <vector>

#include "tests/sim/support/body_table.hpp"
#include "tests/sim/support/region_boxes.hpp"
#include "tests/sim/support/two_boxes.hpp"

namespace palpate::sim {
namespace {

using testing::AllOf;
using testing::HasSubstr;

std::string refusal(const std::filesystem::path& scene, const std::vector<Override>& overrides = {}) {
  try {
    test::compile_scene(scene, overrides);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

std::string held_by_a_region(const std::string& model) {
  const std::string upper = test::without_fixed(test::body_table("upper", "z_max", "z_min"));
  return refusal(
      test::write_region_boxes(upper, test::body_table("lower", "z_min", "z_max"),
                               "[contact]\ntouch = [[\"upper\", \"lower\"]]\nmodel = \"" + model + "\"\n",
                               test::region_table("hand", "upper", "z_max", "20 mm")));
}

// Their frames do not turn, and what faces what stays.
TEST(Refusals, ARegionThatGoesFarUnderALawThatDoesNotFollow) {
  for (const char* model : {"kuroda", "sibille"})
    EXPECT_THAT(held_by_a_region(model),
                AllOf(HasSubstr("probes.hand.reach"),
                      HasSubstr("accepted: the probe without reach, or contact.model = "
                                "\"exact\"")));
  EXPECT_EQ(held_by_a_region("exact"), "");
}

TEST(Refusals, SinglePrecisionWhereTheComplianceChanges) {
  const std::vector<Override> single{{"contact.model", "exact"}, {"contact.precision", "single"}};
  EXPECT_EQ(refusal(test::write_two_boxes(), single), "");
  std::vector<Override> rough = single;
  rough.push_back({"contact.friction", "0.3"});
  EXPECT_THAT(refusal(test::write_two_boxes(), rough),
              AllOf(HasSubstr("contact.precision"), HasSubstr("accepted: \"double\"")));
  EXPECT_THAT(refusal(test::write_two_boxes({.probe = "kind = \"pad\"\nradius = \"6 mm\"\nreach = \"3 mm\""}),
                      single),
              HasSubstr("contact.precision"));
}

}  // namespace
}  // namespace palpate::sim
