#include "analysis/detection/detection_words.hpp"

#include <fmt/core.h>

#include <cmath>

#include "analysis/numerics/to_json.hpp"
#include "analysis/words/words.hpp"

namespace palpate::analysis {

Input correction_input(const std::string& usual) {
  return {.name = "correction",
          .kind = Input::Kind::Choice,
          .meaning = "What is done at 0 and 100 %",
          .usual = usual,
          .choices = {"half-trial", "log-linear", "none"}};
}

std::vector<Output> detection_outputs() {
  return {{"hits", "That answer, rightly given"},
          {"signal_trials", "Trials where it was right"},
          {"false_alarms", "That answer, wrongly given"},
          {"noise_trials", "Trials where it was wrong"},
          {"hit_rate", "that entered the model, after the correction"},
          {"false_alarm_rate", "that entered the model, after the correction"},
          {"correction", "at 0 and 100 %"},
          {"corrected", "Whether it changed a rate"},
          {"d_prime", "d'; null where it is infinite"},
          {"standard_error", "by the delta method; null where there is none"},
          {"interval", "for d', by profile likelihood of the counts as they are"}};
}

void put_detection(nlohmann::ordered_json& json, const Detection& detection) {
  json["hits"] = detection.counts.hits;
  json["signal_trials"] = detection.counts.signal_trials;
  json["false_alarms"] = detection.counts.false_alarms;
  json["noise_trials"] = detection.counts.noise_trials;
  json["hit_rate"] = detection.hit_rate;
  json["false_alarm_rate"] = detection.false_alarm_rate;
  json["correction"] = name_of(detection.correction);
  json["corrected"] = detection.corrected;
  json["d_prime"] = to_json(detection.d_prime);
  json["standard_error"] = to_json(detection.standard_error);
  json["interval"] = to_json(detection.interval);
}

std::string detection_in_words(const Detection& detection, const std::string& signal,
                               const std::string& noise) {
  const DetectionCounts& counts = detection.counts;
  const auto rate = [](const std::string& what, long yes, long trials) {
    const double share = static_cast<double>(yes) / static_cast<double>(trials);
    return fmt::format("{}: {} of {}, {}\n", what, yes, trials, percent(share));
  };
  return rate(signal, counts.hits, counts.signal_trials) +
         rate(noise, counts.false_alarms, counts.noise_trials) +
         (detection.corrected
              ? fmt::format("Corrected to {} and {} ({}).\n", percent(detection.hit_rate),
                            percent(detection.false_alarm_rate), name_of(detection.correction))
              : "") +
         fmt::format("d' = {} (standard error {})\n{} interval: {} ({})\n", number(detection.d_prime),
                     std::isfinite(detection.standard_error) ? number(detection.standard_error) : "none",
                     short_percent(detection.interval.level), range(detection.interval),
                     detection.interval.method);
}

}  // namespace palpate::analysis
