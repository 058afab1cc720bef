// One test a case, of its name: once exactly, ten times with jitter.
#include <gtest/gtest.h>

#include <ostream>
#include <set>

#include "tests/hard_cases/hard_case.hpp"

namespace palpate::hard_cases {

void PrintTo(const HardCase& hard_case, std::ostream* out) {
  *out << hard_case.number << ", " << hard_case.title;
}

namespace {

class HardCases : public testing::TestWithParam<HardCase> {};

TEST_P(HardCases, Holds) {
  const std::vector<Outcome> outcomes = run_all(GetParam());
  for (std::size_t run = 0; run < outcomes.size(); ++run) {
    const Outcome& outcome = outcomes[run];
    EXPECT_TRUE(outcome.holds()) << GetParam().title << ", " << (run == 0 ? "exactly" : "with jitter ") << run
                                 << ": " << GetParam().figure << " = " << outcome.figure << ", must be at "
                                 << (outcome.bound == Bound::AtMost ? "most " : "least ") << outcome.limit;
    for (const std::string& fault : outcome.faults) ADD_FAILURE() << "run " << run << ": " << fault;
  }
}

INSTANTIATE_TEST_SUITE_P(Catalogue, HardCases, testing::ValuesIn(hard_cases().begin(), hard_cases().end()),
                         [](const auto& named) { return named.param.name; });

TEST(HardCaseCatalogue, GivesEachCaseANumberAndANameOfItsOwn) {
  std::set<int> numbers;
  std::set<std::string> names;
  for (const HardCase& hard_case : hard_cases()) {
    EXPECT_TRUE(numbers.insert(hard_case.number).second) << hard_case.number;
    EXPECT_TRUE(names.insert(hard_case.name).second) << hard_case.name;
  }
  for (const OpenCase& open : open_cases()) EXPECT_TRUE(numbers.insert(open.number).second) << open.number;
  EXPECT_EQ(*numbers.rbegin(), std::ssize(numbers));  // none is missing
}

}  // namespace
}  // namespace palpate::hard_cases
