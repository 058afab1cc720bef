#include "analysis/statistics/randomisation/description.hpp"

#include <fmt/core.h>

#include <numeric>
#include <stdexcept>

#include "analysis/binomial/to_json.hpp"
#include "analysis/description/phrases.hpp"
#include "analysis/numerics/to_json.hpp"
#include "analysis/statistics/randomisation/order_randomisation.hpp"
#include "analysis/words/words.hpp"

namespace palpate::analysis {
namespace {

constexpr long kMostRandomised = 10'000;  // the test's time grows with their square: some seconds

std::vector<OrderStratum> strata_of(const DataTable& table) {
  const auto trials = count_column(table, "trials"), first = count_column(table, "correct_first"),
             answers = count_column(table, "answers_first"), correct = count_column(table, "correct");
  std::vector<OrderStratum> strata;
  for (std::size_t i = 0; i < trials.size(); ++i) {
    strata.push_back({trials[i], first[i], answers[i], correct[i]});
    at_row(table, i, [&] { validate(strata.back()); });
  }
  const long all = std::accumulate(trials.begin(), trials.end(), 0L);
  if (all <= kMostRandomised) return strata;
  throw std::invalid_argument(
      fmt::format("{}: {} trials in all; accepted: up to {}, for every order is counted", table.source, all,
                  kMostRandomised));
}

std::string in_words(const OrderRandomisationTest& test, Side side) {
  std::string region = "No number of correct answers";
  if (test.critical.at_least) region = fmt::format("{} or more", *test.critical.at_least);
  if (test.critical.at_most) region = fmt::format("{} or fewer", *test.critical.at_most);
  if (test.critical.at_least && test.critical.at_most)
    region = fmt::format("{} or fewer, or {} or more", *test.critical.at_most, *test.critical.at_least);
  return fmt::format(
             "{} of {} correct; whoever feels nothing and answers so has {} on the average (standard "
             "deviation {})\n",
             test.correct, test.trials, number(test.expected), number(test.standard_deviation)) +
         p_line(test.p, side) +
         fmt::format("{} of {} would reject at alpha {} (probability under guessing {})\n", region,
                     test.trials, test.critical.alpha, number(test.critical.size)) +
         method_line(test.method);
}

nlohmann::ordered_json randomisation_json(const OrderRandomisationTest& test, Side side) {
  nlohmann::ordered_json json = {{"procedure", "randomisation"},
                                 {"correct", test.correct},
                                 {"trials", test.trials},
                                 {"expected", test.expected},
                                 {"standard_deviation", test.standard_deviation},
                                 {"p_values", to_json(test.p)},
                                 {"critical", to_json(test.critical)},
                                 {"method", to_json(test.method)}};
  put_side(json, side);
  return json;
}

Outcome randomisation_outcome(const Arguments& asked) {
  const OrderRandomisationTest test =
      order_randomisation_test(strata_of(asked.table), asked.number("alpha"), asked.side());
  return {.json = randomisation_json(test, asked.side()), .text = in_words(test, asked.side())};
}

}  // namespace

Statistic randomisation_statistic() {
  return {
      .name = "randomisation",
      .question = "Are more answers correct than guessing gives, when the orders were balanced?",
      .title = "randomisation test over the admissible orders",
      .teaches =
          "For two-interval studies in which each examinee met either order equally often. Balanced orders "
          "are not independent, so the binomial test does not hold. Whoever feels nothing would have "
          "answered the same whatever order had been drawn: the answers are held fixed and every order that "
          "could have been drawn counts as much as the one that was. Exact.",
      .inputs = {alpha_input(), side_input("greater")},
      .data = {.shape = Data::Shape::Columns,
               .meaning = "one examinee (and cell) a row",
               .columns = {{.name = "trials",
                            .meaning = fmt::format("Answers; in all rows up to {}", kMostRandomised)},
                           {.name = "correct_first", .meaning = "of them with the correct interval first"},
                           {.name = "answers_first", .meaning = "of them answered 1"},
                           {.name = "correct", .meaning = "of them correct"}}},
      .outputs = {{"correct", "Correct answers of all"},
                  {"trials", "Answers of all"},
                  {"expected", "Correct answers of whoever feels nothing and answers so"},
                  {"standard_deviation", "of them"},
                  {"side", "Alternative that was asked for"},
                  {"p", "p value of that side"},
                  {"p_values", "of all three sides"},
                  {"critical", "Numbers that reject at alpha, given the answers"}},
      .example = {{"data",
                   {{"trials", {4, 4, 4, 4}},
                    {"correct_first", {2, 2, 2, 2}},
                    {"answers_first", {2, 1, 2, 2}},
                    {"correct", {4, 3, 4, 2}}}}},
      .run = randomisation_outcome};
}

}  // namespace palpate::analysis
