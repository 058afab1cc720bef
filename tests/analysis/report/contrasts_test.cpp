#include "analysis/report/contrasts.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <random>

#include "analysis/report/report.hpp"
#include "analysis/report/summary.hpp"
#include "tests/analysis/report/fixture.hpp"

using namespace palpate::analysis;
using testing::ElementsAre;
using testing::HasSubstr;

namespace {

/// Two factors of two levels, the second one fastest.
StudyTable two_by_two(const std::vector<std::vector<int>>& correct, int trials) {
  StudyTable table = test::study_table(correct, trials);
  table.design.factors = {"gap", "contact.model"};
  table.design.cells = {{"near, kuroda", {"near", "kuroda"}},
                        {"near, sibille", {"near", "sibille"}},
                        {"far, kuroda", {"far", "kuroda"}},
                        {"far, sibille", {"far", "sibille"}}};
  table.design.planned_examinees = static_cast<int>(correct.size());
  return table;
}

}  // namespace

// Equal fractions of whatever numbers of trials, told by cross products.
TEST(ContrastOf, IsOneNumberForOneFraction) {
  const Contrast difference{.weights = {1, -1}};
  std::mt19937_64 random(4);
  std::uniform_int_distribution<long> trials(1, 60);
  const auto draw = [&] {
    const long n = trials(random);
    return ExamineeCount{.correct = std::uniform_int_distribution<long>(0, n)(random), .trials = n};
  };
  int equal = 0;
  std::vector<std::array<long, 2>> fractions;
  std::vector<double> numbers;
  for (int i = 0; i < 1000; ++i) {
    const ExamineeCount a = draw(), b = draw();
    fractions.push_back({a.correct * b.trials - b.correct * a.trials, a.trials * b.trials});
    numbers.push_back(*contrast_of(difference, {a, b}));
  }
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const bool same = fractions[i][0] * fractions[j][1] == fractions[j][0] * fractions[i][1];
      ASSERT_EQ(numbers[i] == numbers[j], same) << i << ' ' << j;
      equal += same;
    }
  }
  EXPECT_GT(equal, 100);
}

TEST(Contrasts, OfTwoByTwoAreBothMainEffectsAndTheInteraction) {
  const StudyDesign design = two_by_two({}, 4).design;
  ASSERT_EQ(planned_contrasts(design), 3u);
  const std::vector<Contrast> all = contrasts(design);
  ASSERT_EQ(all.size(), 3u + 6u);
  EXPECT_THAT(all[0].weights, ElementsAre(1, 1, -1, -1));
  EXPECT_THAT(all[1].weights, ElementsAre(1, -1, 1, -1));
  EXPECT_THAT(all[2].weights, ElementsAre(1, -1, -1, 1));
  EXPECT_EQ(all[0].divisor, 2);
  EXPECT_EQ(all[2].divisor, 1);
  EXPECT_EQ(name_of(all[0]), "gap, near against far");
  EXPECT_EQ(name_of(all[1]), "contact.model, kuroda against sibille");
  EXPECT_EQ(name_of(all[2]), "interaction of gap and contact.model");
  EXPECT_EQ(name_of(all[3]), "near, kuroda against near, sibille");
}

TEST(Contrasts, AreNotPlannedWhereTheProtocolNamesNoTest) {
  StudyDesign design = two_by_two({}, 4).design;
  design.between_models = "none";
  EXPECT_EQ(planned_contrasts(design), 0u);
  EXPECT_EQ(contrasts(design).size(), 6u);
}

TEST(Contrasts, OfAFactorWithOneLevelIsThatOfTheOther) {
  StudyDesign design = test::study_table({}).design;
  design.factors = {"gap", "contact.model"};
  design.cells = {{"near, kuroda", {"near", "kuroda"}}, {"near, sibille", {"near", "sibille"}}};
  EXPECT_EQ(planned_contrasts(design), 1u);
  EXPECT_EQ(factors_in_words(design), "contact.model");
}

// R 4.2: nk <- c(9,8,10,7,9,8,10,9); ns <- c(6,5,5,7,4,6,5,6); fk <- c(8,8,9,7,7,9,8,8); fs <- c(6,6,7,5,6,7,5,6)
//   S <- 1 - 2 * as.matrix(expand.grid(rep(list(0:1), 8)))
//   p <- function(d) mean(abs(S %*% d) >= abs(sum(d)) - 1e-9); a <- (nk+ns-fk-fs)/20
//   c(mean(a), p(a)); b <- (nk-ns+fk-fs)/20; c(mean(b), p(b)); i <- (nk-ns-fk+fs)/10; c(mean(i), p(i))
TEST(Contrasts, AreTestedWithinExaminees) {
  const std::vector<std::array<int, 4>> counts{{9, 6, 8, 6}, {8, 5, 8, 6}, {10, 5, 9, 7}, {7, 7, 7, 5},
                                               {9, 4, 7, 6}, {8, 6, 9, 7}, {10, 5, 8, 5}, {9, 6, 8, 6}};
  std::vector<std::vector<int>> correct;
  for (const auto& row : counts) correct.emplace_back(row.begin(), row.end());
  StudyTable table = two_by_two(correct, 10);
  table.design.adjust = "holm";
  const StudyReport report = analyse(table);
  ASSERT_EQ(report.comparisons.size(), 9u);
  const std::array<double, 3> mean{0.0125, 0.2625, 0.125}, p{0.8125, 0.0078125, 0.140625};
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(report.comparisons[i].mean_difference, mean[i], 1e-12) << i;
    EXPECT_NEAR(report.comparisons[i].sign_flip->p.two_sided, p[i], 1e-12) << i;
    EXPECT_EQ(report.comparisons[i].planned, "sign-flip");
  }
  EXPECT_EQ(report.comparisons[3].planned, "none");
  // R 4.2: p.adjust(c(0.8125, 0.0078125, 0.140625), "holm")
  const std::array<double, 3> adjusted{0.8125, 0.0234375, 0.28125};
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(*report.comparisons[i].p_adjusted, adjusted[i], 1e-12) << i;
  EXPECT_FALSE(report.comparisons[3].p_adjusted);
  EXPECT_THAT(comparison_summary(report, report.comparisons[2]),
              HasSubstr("near less far, is 12.5 percentage points larger with kuroda than with sibille"));
}

// The sentence turns a negative difference round, and its interval with it.
TEST(Contrasts, SayWhichIsHigherWithAnIntervalOfTheSameSign) {
  std::vector<std::vector<int>> correct;
  for (const std::vector<int>& row : test::like_the_paper()) correct.push_back({row[1], row[0]});
  const StudyReport turned = analyse(test::study_table(correct)),
                    report = analyse(test::study_table(test::like_the_paper()));
  const auto interval = [](const StudyReport& of) {
    const std::string text = comparison_summary(of, of.comparisons[0]);
    return text.substr(text.find("interval"), text.find(')') - text.find("interval"));
  };
  EXPECT_EQ(interval(turned), interval(report));
}
