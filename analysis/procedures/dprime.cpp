#include "analysis/statistics/dprime.hpp"

#include <fmt/core.h>

#include "analysis/procedures/all.hpp"
#include "analysis/procedures/phrases.hpp"
#include "analysis/statistics/to_json.hpp"
#include "analysis/words.hpp"

namespace palpate::analysis {
namespace {

std::string in_words(const DPrime& d_prime) {
  const double observed = static_cast<double>(d_prime.correct) / static_cast<double>(d_prime.trials);
  return fmt::format("{} of {} correct: {}\n", d_prime.correct, d_prime.trials, percent(observed)) +
         (d_prime.corrected ? fmt::format("Corrected to {} ({}).\n", percent(d_prime.proportion),
                                          name_of(d_prime.correction))
                            : "") +
         fmt::format("d' = {} (standard error {})\n{} interval: {} ({})\n", number(d_prime.d_prime),
                     number(d_prime.standard_error), short_percent(d_prime.interval.level),
                     range(d_prime.interval), d_prime.interval.method) +
         method_line(d_prime.method);
}

Outcome run(const Arguments& asked) {
  const DPrime d_prime = dprime_2ifc(asked.count("correct"), asked.count("trials"),
                                     correction_from_name(asked.text("correction")), asked.level());
  return {.json = to_json(d_prime), .text = in_words(d_prime)};
}

}  // namespace

Procedure dprime_procedure() {
  return {.name = "dprime",
          .question = "How well are two stimuli told apart?",
          .title = "d' of a two-interval forced choice",
          .teaches =
              "d' = sqrt(2) z(proportion correct): the distance between the two stimuli in standard "
              "deviations of "
              "what one interval feels like, for an observer who prefers neither interval. At 0 and 100 % it "
              "would "
              "be infinite: half-trial puts 1/(2n) and 1 - 1/(2n) there (Macmillan & Kaplan 1985), "
              "log-linear always "
              "takes (k + 1/2)/(n + 1) (Hautus 1995), none leaves it.",
          .inputs = {correct_input(),
                     trials_input(),
                     {.name = "correction",
                      .kind = Input::Kind::Choice,
                      .meaning = "What is done at 0 and 100 %",
                      .usual = "half-trial",
                      .choices = {"half-trial", "log-linear", "none"}},
                     level_input()},
          .outputs = {{"task", "2IFC"},
                      {"correct", "Correct answers"},
                      {"trials", "All answers"},
                      {"proportion", "that entered z, after the correction"},
                      {"correction", "at 0 and 100 %"},
                      {"corrected", "Whether it changed the proportion"},
                      {"d_prime", "d'; null where it is infinite"},
                      {"standard_error", "by the delta method"},
                      {"interval", "from the exact interval for the proportion"}},
          .example = {{"correct", 41}, {"trials", 60}},
          .run = run};
}

}  // namespace palpate::analysis
