#include "analysis/psychometric/request.hpp"

#include <fmt/core.h>

#include <stdexcept>

#include "analysis/description/read_number.hpp"
#include "analysis/description/statistic.hpp"
#include "analysis/numerics/result.hpp"
#include "analysis/numerics/rounding.hpp"
#include "base/text/shard.hpp"

namespace palpate::analysis {
namespace {

using Kind = Input::Kind;

constexpr long kFewestReplicates = 199, kMostReplicates = 10'000'000;
constexpr long kMostBootstrapped = 1'000'000;  // trials: the chance of each number correct is tabulated

void require_replicates(long replicates, bool bootstrap_intervals) {
  if (replicates == 0 && !bootstrap_intervals) return;
  if (replicates >= kFewestReplicates && replicates <= kMostReplicates) return;
  throw std::invalid_argument(fmt::format("replicates is {}; accepted: {} to {}{}", replicates,
                                          kFewestReplicates, kMostReplicates,
                                          bootstrap_intervals ? "" : ", or 0 for no bootstrap"));
}

void require_few_trials(const std::vector<Block>& blocks) {
  long all = 0;
  for (const Block& block : blocks) all += block.trials;
  if (all <= kMostBootstrapped) return;
  throw std::invalid_argument(fmt::format(
      "{} trials in all; accepted: up to {}, or replicates 0 for no bootstrap", all, kMostBootstrapped));
}

}  // namespace

std::vector<Block> blocks_of(const DataTable& table) {
  const std::vector<double> levels = settled_values(number_column(table, "level"));
  const std::vector<long> correct = count_column(table, "correct"), trials = count_column(table, "trials");
  std::vector<Block> blocks;
  for (std::size_t i = 0; i < levels.size(); ++i) {
    blocks.push_back({levels[i], correct[i], trials[i]});
    at_row(table, i, [&] { require_counts(correct[i], trials[i]); });
  }
  return blocks;
}

PsychometricModel model_of(const Arguments& asked) {
  PsychometricModel model{.shape = shape_from_name(asked.text("shape")),
                          .guess = asked.number("guess"),
                          .lapse_upper = asked.number("lapse-max"),
                          .threshold_at = asked.number("threshold-at")};
  const std::string lapse = asked.text("lapse");
  if (lapse != "free") {
    const auto fixed = read_fraction(lapse);
    if (!fixed) {
      throw std::invalid_argument(
          fmt::format("lapse is '{}'; accepted: free, or a number such as 0.02", lapse));
    }
    model.lapse_lower = model.lapse_upper = *fixed;
  }
  validate(model);
  return model;
}

PsychometricRequest psychometric_request(const Arguments& asked) {
  PsychometricRequest request{.blocks = blocks_of(asked.table),
                              .model = model_of(asked),
                              .level = asked.level(),
                              .bootstrap_intervals = asked.text("intervals") == "bootstrap",
                              .bootstrap = bootstrap_from_name(asked.text("bootstrap")),
                              .replicates = asked.count("replicates"),
                              .seed = static_cast<std::uint64_t>(asked.count("seed"))};
  require_level(request.level, "level");
  require_replicates(request.replicates, request.bootstrap_intervals);
  if (request.replicates > 0) require_few_trials(request.blocks);
  if (!asked.given("standard")) return request;
  request.standard = asked.number("standard");
  if (*request.standard > 0) return request;
  throw std::invalid_argument(
      fmt::format("standard is {}; a Weber fraction needs a standard above 0", *request.standard));
}

base::Shard shard_from_text(const std::string& text) {
  const auto shard = base::parse_shard(text);
  if (shard && shard->n <= kMostReplicates) return *shard;
  throw std::invalid_argument(
      fmt::format("shard is '{}'; accepted: K/N with K from 1 to N, such as 2/4", text));
}

nlohmann::ordered_json to_json(const PsychometricRequest& request) {
  nlohmann::ordered_json blocks = nlohmann::ordered_json::array();
  for (const Block& block : request.blocks) blocks.push_back({block.level, block.correct, block.trials});
  const PsychometricModel& model = request.model;
  return {{"blocks", blocks},
          {"shape", name_of(model.shape)},
          {"guess", model.guess},
          {"lapse_lower", model.lapse_lower},
          {"lapse_upper", model.lapse_upper},
          {"threshold_at", model.threshold_at},
          {"standard", request.standard ? nlohmann::ordered_json(*request.standard) : nullptr},
          {"level", request.level},
          {"intervals", request.bootstrap_intervals ? "bootstrap" : "profile"},
          {"bootstrap", name_of(request.bootstrap)},
          {"replicates", request.replicates},
          {"seed", request.seed}};
}

PsychometricRequest request_from_json(const nlohmann::ordered_json& json) {
  PsychometricRequest request{.model = {.shape = shape_from_name(json.at("shape").get<std::string>()),
                                        .guess = json.at("guess"),
                                        .lapse_lower = json.at("lapse_lower"),
                                        .lapse_upper = json.at("lapse_upper"),
                                        .threshold_at = json.at("threshold_at")},
                              .level = json.at("level"),
                              .bootstrap_intervals = json.at("intervals") == "bootstrap",
                              .bootstrap = bootstrap_from_name(json.at("bootstrap").get<std::string>()),
                              .replicates = json.at("replicates"),
                              .seed = json.at("seed")};
  for (const auto& block : json.at("blocks"))
    request.blocks.push_back({block.at(0), block.at(1), block.at(2)});
  if (!json.at("standard").is_null()) request.standard = json.at("standard").get<double>();
  validate(request.blocks);
  validate(request.model);
  return request;
}

Input shape_input() {
  return {.name = "shape",
          .kind = Kind::Choice,
          .meaning = "Form of F; gumbel-left is 1 - exp(-exp(x)), gumbel-right its mirror image",
          .usual = "logistic",
          .choices = {"logistic", "gaussian", "weibull", "gumbel-left", "gumbel-right"}};
}

Input guess_input() {
  return {.name = "guess",
          .kind = Kind::Fraction,
          .meaning = "psi far below threshold: 1/m with m choices, 0 where answers tell which felt more",
          .usual = "1/2"};
}

std::vector<Input> lapse_inputs() {
  return {{.name = "lapse",
           .kind = Kind::Text,
           .meaning = "Share of answers that miss whatever the level: free, or a number",
           .usual = "free"},
          {.name = "lapse-max",
           .kind = Kind::Fraction,
           .meaning = "Upper bound of a free lapse rate",
           .usual = "0.05"}};
}

Input threshold_at_input() {
  return {.name = "threshold-at",
          .kind = Kind::Fraction,
          .meaning = "The value of F at which the level is called the threshold",
          .usual = "0.5"};
}

Data block_data() {
  return {.shape = Data::Shape::Columns,
          .meaning = "a row for each block of trials at one level",
          .columns = {{.name = "level", .meaning = "Level of the stimulus"},
                      {.name = "correct", .meaning = "Correct answers (or answers that it felt more)"},
                      {.name = "trials", .meaning = "All answers"}}};
}

}  // namespace palpate::analysis
