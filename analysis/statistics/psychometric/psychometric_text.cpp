#include <fmt/core.h>

#include <cmath>

#include "analysis/statistics/psychometric/psychometric_result.hpp"
#include "analysis/words/words.hpp"

namespace palpate::analysis {
namespace {

std::string interval_words(const Interval& interval) {
  if (std::isnan(interval.lower)) return interval.method;
  return fmt::format("{} interval {} ({})", short_percent(interval.level), range(interval), interval.method);
}

std::string head(const PsychometricResult& result) {
  const PsychometricModel& model = result.request.model;
  long correct = 0, trials = 0;
  for (const Block& block : result.request.blocks) {
    correct += block.correct;
    trials += block.trials;
  }
  return fmt::format("psi(x) = guess + (1 - guess - lapse) F(x), {}: {}, guess {}\n{}, {} correct of {}\n",
                     name_of(model.shape), formula_of(model.shape),
                     model.guess == 0 ? "0" : chance_in_words(model.guess),
                     counted(std::ssize(result.request.blocks), "block", "blocks"), correct, trials);
}

std::string lapse_line(const PsychometricResult& result) {
  const PsychometricModel& model = result.request.model;
  if (!lapse_is_free(model)) return fmt::format("Lapse rate: {}, fixed\n", percent(model.lapse_upper));
  const Interval& interval = result.lapse.interval;
  return fmt::format("Lapse rate: {}, free from {} to {}; {}\n", percent(result.lapse.value),
                     percent(model.lapse_lower), percent(model.lapse_upper),
                     std::isnan(interval.lower) ? interval.method
                                                : fmt::format("{} interval {}", short_percent(interval.level),
                                                              percent_range(interval)));
}

std::string discrimination_lines(const PsychometricResult& result) {
  std::string lines;
  if (result.pse) {
    lines += fmt::format("Point of subjective equality (F = 0.5): {}; {}\n", number(result.pse->value),
                         interval_words(result.pse->interval));
  }
  if (result.jnd) {
    lines += fmt::format("Just noticeable difference ({}): {}; {}\n",
                         result.request.model.guess == 0 ? "half the way from F = 0.25 to F = 0.75"
                                                         : "the threshold less the standard",
                         number(result.jnd->value), interval_words(result.jnd->interval));
  }
  if (result.weber) {
    lines +=
        fmt::format("Weber fraction (it over the standard, {}): {}; {}\n", number(*result.request.standard),
                    number(result.weber->value), interval_words(result.weber->interval));
  }
  return lines;
}

std::string chi_squared_words(const Deviance& deviance, const std::string& each) {
  if (deviance.p_chi_squared)
    return fmt::format("; {} by the chi-squared distribution, an approximation",
                       p_in_words(*deviance.p_chi_squared));
  if (deviance.degrees_of_freedom > 0 && deviance.trials_each < kFewestTrials)
    return fmt::format("; the chi-squared distribution does not hold for {} a {} on the average",
                       deviance.trials_each == 1 ? "one trial" : number(deviance.trials_each) + " trials",
                       each);
  return "";
}

std::string degrees_words(const Deviance& deviance) {
  return fmt::format("{} on {} of freedom", number(deviance.value),
                     counted(static_cast<long>(deviance.degrees_of_freedom), "degree", "degrees"));
}

std::string deviance_line(const PsychometricResult& result) {
  std::string line = "Deviance " + degrees_words(result.deviance);
  if (result.p_bootstrap) {
    line += fmt::format("; {} among {} parametric bootstrap replicates", p_in_words(*result.p_bootstrap),
                        result.request.replicates);
  }
  line += chi_squared_words(result.deviance, "block") + '\n';
  if (result.by_level)
    line += "Blocks of one level taken together: deviance " + degrees_words(*result.by_level) +
            chi_squared_words(*result.by_level, "level") + '\n';
  return line;
}

std::string block_table(const PsychometricResult& result) {
  std::string table =
      "     level  correct  trials  fitted  deviance residual  threshold changes without it by\n";
  for (std::size_t i = 0; i < result.blocks.size(); ++i) {
    const Block& block = result.request.blocks[i];
    const BlockInfluence& influence = result.blocks[i];
    table += fmt::format("{:>10} {:>8} {:>7} {:>7} {:>18} {:>31}\n", number(block.level), block.correct,
                         block.trials, decimals(influence.psi, 3), decimals(influence.residual, 2),
                         number(influence.threshold_change));
  }
  return table;
}

}  // namespace

std::string in_words(const PsychometricResult& result) {
  const PsychometricModel& model = result.request.model;
  std::string text = head(result);
  if (result.why_not) text += fmt::format("No function ({}): {}.\n", result.status, *result.why_not);
  if (result.status == "unfit levels") return text;
  const double psi = model.guess + (1 - model.guess - result.lapse.value) * model.threshold_at;
  text +=
      fmt::format("Threshold (level at F = {}, psi = {}): {}; {}\n", number(model.threshold_at), percent(psi),
                  number(result.threshold.value), interval_words(result.threshold.interval));
  text += fmt::format("Slope (dF/dx there, not scaled by guess and lapse): {}; {}\n",
                      number(result.slope.value), interval_words(result.slope.interval));
  text += lapse_line(result) + discrimination_lines(result) + deviance_line(result);
  return text + block_table(result);
}

}  // namespace palpate::analysis
