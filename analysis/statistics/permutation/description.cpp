#include "analysis/statistics/permutation/description.hpp"

#include <fmt/core.h>

#include "analysis/description/phrases.hpp"
#include "analysis/numerics/to_json.hpp"
#include "analysis/resampling/sign_flip.hpp"
#include "analysis/resampling/to_json.hpp"
#include "analysis/words/words.hpp"

namespace palpate::analysis {
namespace {

std::string in_words(const SignFlipTest& test, Side side) {
  return fmt::format("{}, mean {}\n", counted(static_cast<long>(test.n), "difference", "differences"),
                     number(test.mean)) +
         p_line(test.p, side) +
         fmt::format("{} interval for the mean: {} ({})\n", short_percent(test.interval.level),
                     range(test.interval), test.interval.method) +
         method_line(test.method);
}

Outcome permutation_outcome(const Arguments& asked) {
  const SignFlipTest test = sign_flip_test(number_column(asked.table, "difference"),
                                           {.level = asked.level(),
                                            .resamples = asked.count("resamples"),
                                            .seed = static_cast<std::uint64_t>(asked.count("seed"))});
  Outcome outcome{.json = to_json(test), .text = in_words(test, asked.side())};
  put_side(outcome.json, asked.side());
  return outcome;
}

}  // namespace

Statistic permutation_statistic() {
  return {
      .name = "permutation",
      .question = "Is the mean difference zero?",
      .title = "sign-flip permutation test",
      .teaches =
          "If the two things compared are exchangeable for each examinee, a difference has either sign with "
          "probability 1/2. The test counts the sign patterns whose sum is as extreme as the one seen: all "
          "of them where that can be done (up to 20 differences, or whole steps of a common unit), else a "
          "seeded sample.",
      .inputs = {side_input("two-sided"),
                 {.name = "resamples",
                  .kind = Input::Kind::Count,
                  .meaning = "Size of the random sample of patterns",
                  .usual = std::to_string(SignFlipOptions{}.resamples)},
                 {.name = "seed",
                  .kind = Input::Kind::Seed,
                  .meaning = "Of that sample",
                  .usual = std::to_string(SignFlipOptions{}.seed)},
                 level_input()},
      .data = difference_data("One thing less the other, for each examinee"),
      .outputs = {{"n", "Differences given, zeros included"},
                  {"mean", "of the differences"},
                  {"side", "Alternative that was asked for"},
                  {"p", "p value of that side"},
                  {"p_values", "of all three sides"},
                  {"exact", "Whether all sign patterns were counted"},
                  {"resamples", "Patterns drawn; 0 when exact"},
                  {"seed", "of the random part; null when there is none"},
                  {"interval", "for the mean, by inverting the test"}},
      .example = {{"data", {{"difference", {3, 1, 2, -1, 4, 2, 0, 3, 1, 2}}}}},
      .run = permutation_outcome};
}

}  // namespace palpate::analysis
