// What makes a study honest, over 10 000 simulated studies under every protocol that is shipped: whoever
// feels nothing is found to feel something in at most alpha of them, whatever rule is followed; and whoever
// feels something as often as the plan says.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <random>
#include <span>
#include <string>
#include <vector>

#include "analysis/report/primary_power.hpp"
#include "analysis/report/primary_test.hpp"
#include "analysis/report/verdict.hpp"
#include "app/study/study_table.hpp"
#include "tests/support/places.hpp"
#include "trials/plan/plan.hpp"
#include "trials/protocol/protocol.hpp"

namespace palpate::app {
namespace {

constexpr int kStudies = 10'000;

// Answers a trial by a rule; knows all earlier trials of the sitting and what it answered, and feels nothing.
class Guesser {
 public:
  virtual ~Guesser() = default;
  virtual int answer(std::mt19937_64& random, std::size_t cell) = 0;  // the cell, should it leak
  virtual void told(std::size_t, int) {}  // with feedback: which answer was right in a trial of this cell
};

struct Random : Guesser {
  int answer(std::mt19937_64& random, std::size_t) override { return random() % 2 == 0 ? 1 : 2; }
};

struct AlwaysFirst : Guesser {
  int answer(std::mt19937_64&, std::size_t) override { return 1; }
};

struct Alternating : Guesser {
  int next = 1;
  int answer(std::mt19937_64&, std::size_t) override { return next = 3 - next; }
};

// Keeps its answers even within each cell, as somebody who has heard that orders are balanced.
struct Counting : Guesser {
  std::map<std::size_t, int> surplus;  // of "1"
  int answer(std::mt19937_64& random, std::size_t cell) override {
    const int answer = surplus[cell] > 0 ? 2 : surplus[cell] < 0 ? 1 : (random() % 2 == 0 ? 1 : 2);
    surplus[cell] += answer == 1 ? 1 : -1;
    return answer;
  }
};

// Answers what was right the last time.
struct Repeating : Guesser {
  int right = 1;
  int answer(std::mt19937_64&, std::size_t) override { return right; }
  void told(std::size_t, int correct) override { right = correct; }
};

// Answers what has been right less often in the cell, as somebody who has heard that orders are balanced.
struct Reckoning : Guesser {
  std::map<std::size_t, int> surplus;  // of trials in which "1" was right
  int answer(std::mt19937_64& random, std::size_t cell) override {
    return surplus[cell] > 0 ? 2 : surplus[cell] < 0 ? 1 : (random() % 2 == 0 ? 1 : 2);
  }
  void told(std::size_t cell, int correct) override { surplus[cell] += correct == 1 ? 1 : -1; }
};

/// A whole sitting's answers by a rule, which hears what was right where the protocol says so.
std::vector<int> answers_of(Guesser& rule, const std::vector<trials::Trial>& plan, bool feedback,
                            std::mt19937_64& random) {
  std::vector<int> answers;
  for (const trials::Trial& trial : plan) {
    answers.push_back(rule.answer(random, trial.cell));
    if (feedback) rule.told(trial.cell, trial.correct_answer);
  }
  return answers;
}

using Sittings = std::vector<std::vector<analysis::OrderStratum>>;  // of each cell

void count(Sittings& sittings, const trials::Protocol& protocol, const std::vector<trials::Trial>& plan,
           const std::vector<int>& answers) {
  std::vector<analysis::OrderStratum> strata(protocol.cells.size());
  for (std::size_t i = 0; i < plan.size(); ++i) {
    analysis::OrderStratum& stratum = strata[plan[i].cell];
    ++stratum.trials;
    stratum.correct_first += plan[i].correct_answer == 1 ? 1 : 0;
    stratum.answers_first += answers[i] == 1 ? 1 : 0;
    stratum.correct += answers[i] == plan[i].correct_answer ? 1 : 0;
  }
  for (std::size_t cell = 0; cell < strata.size(); ++cell) sittings[cell].push_back(strata[cell]);
}

// Whether the primary test rejects in `cell`, at the looks that the protocol plans or at the end. Regions
// that do not depend on the answers are computed once.
class PrimaryTestOfStudies {
 public:
  explicit PrimaryTestOfStudies(const trials::Protocol& protocol)
      : design_(design_of(protocol)), looks_(protocol.analysis.looks) {
    if (looks_.empty()) looks_.push_back(protocol.planned_examinees);
    // Of a cell that is alone in rejecting, where the protocol adjusts over the cells: what its power is planned for.
    design_.alpha = analysis::strictest_alpha(design_);
  }

  bool rejects(const std::vector<analysis::OrderStratum>& sittings) {
    for (const int look : looks_) {
      const std::span<const analysis::OrderStratum> seen(sittings.data(), look);
      long correct = 0;
      for (const analysis::OrderStratum& sitting : seen) correct += sitting.correct;
      if (analysis::rejects(region(seen, look), correct)) return true;
    }
    return false;
  }

 private:
  analysis::CriticalNumber region(std::span<const analysis::OrderStratum> seen, int look) {
    if (design_.interval_order == "balanced")
      return analysis::order_randomisation_test(seen, design_.alpha, analysis::side_from_name(design_.side))
          .critical;
    const auto known = regions_.find(look);
    if (known != regions_.end()) return known->second;
    return regions_[look] =
               analysis::primary_test(design_, seen, 0.95, analysis::look_due(design_, look)).critical;
  }

  analysis::StudyDesign design_;
  std::vector<int> looks_;
  std::map<int, analysis::CriticalNumber> regions_;
};

class ShippedProtocol : public testing::TestWithParam<std::string> {
 protected:
  trials::Protocol protocol_ = trials::load_protocol(std::filesystem::path(palpate::test::source_folder()) /
                                                     "protocols" / (GetParam() + ".toml"));

  /// Share of studies in which the first cell's test rejects; `answers` answers a plan.
  template <typename Answers>
  double share_rejected(const Answers& answers) {
    PrimaryTestOfStudies test(protocol_);
    trials::Generator order = trials::make_generator(2003, "orders of " + GetParam());
    int rejected = 0;
    for (int study = 0; study < kStudies; ++study) {
      Sittings sittings(protocol_.cells.size());
      for (int examinee = 0; examinee < protocol_.planned_examinees; ++examinee) {
        const auto plan = trials::draw_plan(protocol_, order);
        count(sittings, protocol_, plan, answers(plan));
      }
      rejected += test.rejects(sittings[0]) ? 1 : 0;
    }
    return static_cast<double>(rejected) / kStudies;
  }

  template <typename Rule>
  double share_rejected_of_guessers() {
    std::mt19937_64 random(7);
    return share_rejected([&](const std::vector<trials::Trial>& plan) {
      Rule rule;
      return answers_of(rule, plan, protocol_.feedback, random);
    });
  }
};

// A test of size alpha would be exceeded by chance by three standard errors in one of 700 such tests.
double bound(double alpha) {
  return alpha + 3 * std::sqrt(alpha * (1 - alpha) / kStudies);
}

std::vector<std::string> shipped() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(
           std::filesystem::path(palpate::test::source_folder()) / "protocols"))
    if (entry.path().extension() == ".toml") names.push_back(entry.path().stem());
  std::ranges::sort(names);
  return names;
}

}  // namespace

TEST_P(ShippedProtocol, FindsNothingInGuesses) {
  const double most = bound(protocol_.analysis.alpha);
  EXPECT_LE(share_rejected_of_guessers<Random>(), most);
  EXPECT_LE(share_rejected_of_guessers<AlwaysFirst>(), most);
  EXPECT_LE(share_rejected_of_guessers<Alternating>(), most);
  EXPECT_LE(share_rejected_of_guessers<Counting>(), most);
  if (!protocol_.feedback) return;
  EXPECT_LE(share_rejected_of_guessers<Repeating>(), most);
  EXPECT_LE(share_rejected_of_guessers<Reckoning>(), most);
}

// Why feedback on balanced orders is refused. Of two and two orders that come in random sequence, whoever is told
// which have come and names the one that is left more often is right in 17 of 24 trials: with a and b left it is
// f(a, b) = max(a, b) / (a + b) + the mean of f over what comes, f(2, 2) = 17/6 of 4.
TEST(Feedback, OnBalancedOrdersWouldTellTheAnswers) {
  const auto protocol = trials::load_protocol(std::filesystem::path(palpate::test::source_folder()) /
                                              "protocols/kuroda2003-balanced.toml");
  trials::Generator order = trials::make_generator(2003, "balanced orders with feedback");
  std::mt19937_64 random(7);
  long correct = 0, trials = 0;
  for (int sitting = 0; sitting < kStudies; ++sitting) {
    Reckoning rule;
    const auto plan = trials::draw_plan(protocol, order);
    const std::vector<int> answers = answers_of(rule, plan, true, random);
    for (std::size_t i = 0; i < plan.size(); ++i) correct += answers[i] == plan[i].correct_answer ? 1 : 0;
    trials += std::ssize(plan);
  }
  const double standard_error = 0.5 / std::sqrt(static_cast<double>(trials));  // at most
  EXPECT_NEAR(static_cast<double>(correct) / static_cast<double>(trials), 17.0 / 24.0, 4 * standard_error);
}

// Answers that are right with probability 0.7, whatever the order: the plan's power, within four standard
// errors of the simulation.
TEST_P(ShippedProtocol, FindsATrueEffectAsOftenAsPlanned) {
  std::mt19937_64 random(11);
  std::bernoulli_distribution right(0.7);
  const double found = share_rejected([&](const std::vector<trials::Trial>& plan) {
    std::vector<int> answers;
    for (const trials::Trial& trial : plan)
      answers.push_back(right(random) ? trial.correct_answer : 3 - trial.correct_answer);
    return answers;
  });
  const analysis::Power planned = analysis::primary_power(design_of(protocol_), 0.7);
  const double of_this_simulation = std::sqrt(planned.power * (1 - planned.power) / kStudies);
  EXPECT_NEAR(found, planned.power, 4 * std::hypot(of_this_simulation, planned.standard_error));
}

INSTANTIATE_TEST_SUITE_P(Protocols, ShippedProtocol, testing::ValuesIn(shipped()), [](const auto& name) {
  std::string words = name.param;
  std::ranges::replace(words, '-', '_');
  return words;
});

}  // namespace palpate::app
