#include "analysis/statistics/power/description.hpp"

#include <fmt/core.h>

#include <boost/math/distributions/normal.hpp>
#include <numbers>
#include <stdexcept>

#include "analysis/binomial/to_json.hpp"
#include "analysis/description/phrases.hpp"
#include "analysis/numerics/to_json.hpp"
#include "analysis/statistics/power/power_curve.hpp"
#include "analysis/words/words.hpp"

namespace palpate::analysis {
namespace {

double probability_of(const Arguments& asked) {
  if (asked.given("probability") == asked.given("dprime")) {
    throw std::invalid_argument("power needs one of probability and dprime, not both: the true effect");
  }
  if (asked.given("probability")) return asked.number("probability");
  if (asked.number("chance") != 0.5) {
    throw std::invalid_argument(
        "dprime is that of a two-interval forced choice, whose chance is 1/2; give probability");
  }
  return boost::math::cdf(boost::math::normal_distribution<>(), asked.number("dprime") / std::numbers::sqrt2);
}

std::string size_in_words(const SampleSize& size, const std::optional<long>& trials, double power) {
  if (!trials) return fmt::format("more than {}", size.searched);
  const std::string people =
      size.step > 1 ? fmt::format(" ({})", counted(*trials / size.step, "examinee", "examinees")) : "";
  return fmt::format("{} answers{}, power {}", *trials, people, decimals(power, 4));
}

std::string in_words(const PowerCurve& curve, const PowerAsked& asked, const std::optional<long>& at) {
  std::string text =
      fmt::format("True proportion correct {}, chance {}, alpha {}, side {}\n", percent(asked.probability),
                  chance_in_words(asked.chance), asked.alpha, name_of(asked.side));
  for (std::size_t i = 0; at && i < curve.trials.size(); ++i) {
    if (curve.trials[i] == *at)
      text += fmt::format("Power of {} answers: {}\n", *at, decimals(curve.power[i], 4));
  }
  const SampleSize& size = curve.size;
  if (curve.never)
    return text + fmt::format("{} is never reached: {}\n", short_percent(asked.target), *curve.never) +
           method_line(size.method);
  return text +
         fmt::format("{} is reached first with {}\n", short_percent(asked.target),
                     size_in_words(size, size.first, size.power_at_first)) +
         fmt::format("and no larger number up to {} falls below it from {}\n", size.searched,
                     size_in_words(size, size.lasting, size.power_at_lasting)) +
         method_line(size.method);
}

Outcome power_outcome(const Arguments& asked) {
  const PowerAsked power{.chance = asked.number("chance"),
                         .probability = probability_of(asked),
                         .alpha = asked.number("alpha"),
                         .target = asked.number("target"),
                         .side = asked.side(),
                         .each = asked.count("each"),
                         .overdispersion = asked.number("overdispersion")};
  std::optional<long> at;
  if (asked.given("trials")) at = asked.count("trials");
  const PowerCurve curve = power_curve(power, asked.count("largest"));  // refuses what is no number of each
  if (at && (*at < 1 || *at % power.each != 0 || *at > asked.count("largest"))) {
    throw std::invalid_argument(
        fmt::format("trials is {}; accepted: a multiple of each ({}), at most largest ({})", *at, power.each,
                    asked.count("largest")));
  }
  Outcome outcome{.text = in_words(curve, power, at)};
  outcome.json = {{"procedure", "power"}, {"probability", power.probability}};
  outcome.json["power"] = at ? nlohmann::ordered_json(curve.power[*at / power.each - 1]) : nullptr;
  outcome.json["never"] = curve.never ? nlohmann::ordered_json(*curve.never) : nullptr;
  outcome.json["sample_size"] = to_json(curve.size);
  outcome.json["sawtooth"] = {{"trials", curve.trials}, {"power", curve.power}};
  outcome.json["method"] = to_json(curve.size.method);
  return outcome;
}

}  // namespace

Statistic power_statistic() {
  return {.name = "power",
          .question = "How many answers does a study need?",
          .title = "exact power of the binomial test",
          .teaches =
              "Power is the probability that the test rejects guessing when the truth is as given: by the "
              "proportion correct, or by d' of a two-interval forced choice. The exact test's power rises in "
              "a sawtooth, so that a larger study may have less: the first number with the target and the "
              "number from which it lasts are both given, and the sawtooth itself in JSON. With "
              "overdispersion, examinees differ: their probabilities follow a beta distribution (gamma 0 to "
              "1). For a whole protocol with its looks and balanced orders: palpate plan.",
          .inputs =
              {{.name = "probability",
                .kind = Input::Kind::Fraction,
                .meaning = "True proportion correct",
                .optional = true},
               {.name = "dprime", .meaning = "or: true d' of a two-interval forced choice", .optional = true},
               {.name = "trials",
                .kind = Input::Kind::Count,
                .meaning = "Answers whose power is asked for",
                .optional = true},
               chance_input(),
               alpha_input(),
               side_input("greater"),
               {.name = "target", .kind = Input::Kind::Fraction, .meaning = "Power aimed at", .usual = "0.8"},
               {.name = "each",
                .kind = Input::Kind::Count,
                .meaning = "Answers of one examinee; sizes are its multiples",
                .usual = "1"},
               {.name = "overdispersion", .meaning = "How unlike examinees are, 0 to 1", .usual = "0"},
               {.name = "largest",
                .kind = Input::Kind::Count,
                .meaning = "Most answers that are looked at",
                .usual = "500"}},
          .outputs = {{"probability", "True proportion correct"},
                      {"power", "of `trials` answers; null where none were named"},
                      {"never", "why no number of answers has the target; null where one may"},
                      {"sample_size", "first and lasting numbers of answers with the target"},
                      {"sawtooth", "power of every number of answers looked at"}},
          .example = {{"probability", 0.7}, {"trials", 60}, {"each", 4}},
          .run = power_outcome};
}

}  // namespace palpate::analysis
