#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "analysis/statistics/to_json.hpp"
#include "analysis/words.hpp"
#include "app/commands/commands.hpp"
#include "app/output.hpp"
#include "trials/protocol.hpp"

namespace palpate::app {
namespace {

using namespace analysis;

constexpr double kTargetPower = 0.8;

struct Options {
  std::string protocol, freeze, format;
};

// Power of the planned study, and the examinees that it takes, for one proportion correct.
struct PowerRow {
  double probability = 0.0;
  double d_prime = 0.0;  // of an unbiased observer in 2IFC
  double power = 0.0;
  SampleSize size{};
};

struct Plan {
  trials::Protocol protocol{};
  CriticalNumber critical{};
  std::vector<PowerRow> rows{};
};

// True proportions between chance and certainty, in steps of 5 %, on the side that the test looks at.
std::vector<double> proportions(Side side) {
  std::vector<double> values;
  for (int percent = 55; percent <= 95; percent += 5) {
    values.push_back(side == Side::Less ? (100 - percent) / 100.0 : percent / 100.0);
  }
  return values;
}

Plan plan_of(const std::string& file) {
  Plan plan{.protocol = trials::load_protocol(file)};
  const trials::Protocol& protocol = plan.protocol;
  const long each = protocol.trials_per_examinee_per_cell;
  const double chance = 1.0 / trials::intervals_per_trial(protocol), alpha = protocol.analysis.alpha;
  const Side side = side_from_name(protocol.analysis.side);
  plan.critical = critical_number(each * protocol.planned_examinees, chance, alpha, side);
  for (const double probability : proportions(side)) {
    // The smallest effect listed, 55 %, needs some 620 trials.
    plan.rows.push_back(
        {.probability = probability,
         .d_prime = dprime_2ifc(std::lround(100 * probability), 100, DPrimeCorrection::None).d_prime,
         .power = rejection_probability(plan.critical, probability),
         .size = binomial_sample_size(chance, probability, alpha, side, kTargetPower, each, 2000 + each)});
  }
  return plan;
}

std::string examinees(const std::optional<long>& trials, long each) {
  return trials ? std::to_string(*trials / each) : "more than asked";
}

void print_text(const Plan& plan) {
  const trials::Protocol& protocol = plan.protocol;
  const long each = protocol.trials_per_examinee_per_cell;
  const auto cells = static_cast<long>(protocol.cells.size());
  fmt::print("{}: {} in each of {}, {} for an examinee; {} planned\n", protocol.name,
             counted(each, "trial", "trials"), counted(cells, "cell", "cells"),
             counted(each * cells, "trial", "trials"),
             counted(protocol.planned_examinees, "examinee", "examinees"));
  fmt::print("Primary test: {}, alpha {}, side {}\n\n", protocol.analysis.primary, protocol.analysis.alpha,
             protocol.analysis.side);
  for (const trials::Cell& cell : protocol.cells) {
    fmt::print("{}: {} trials; ", cell.name, plan.critical.trials);
    if (plan.critical.at_least) fmt::print("{} or more correct reject guessing", *plan.critical.at_least);
    if (plan.critical.at_least && plan.critical.at_most) fmt::print(", and ");
    if (plan.critical.at_most) fmt::print("{} or fewer correct reject guessing", *plan.critical.at_most);
    if (!plan.critical.at_least && !plan.critical.at_most)
      fmt::print("no number of correct answers rejects guessing");
    fmt::print(" (probability under guessing {})\n", number(plan.critical.size));
  }
  fmt::print("\n{:>14}  {:>5}  {:>14}  {:>22}  {:>26}\n", "true correct", "d'", "power as planned",
             "examinees for 80 %", "... and any more will do");
  for (const PowerRow& row : plan.rows) {
    fmt::print("{:>14}  {:>5}  {:>16}  {:>22}  {:>26}\n", percent(row.probability), decimals(row.d_prime, 2),
               decimals(row.power, 4), examinees(row.size.first, each), examinees(row.size.lasting, each));
  }
  fmt::print(
      "\nExact power of the binomial test for each cell, were every answer correct with the same "
      "probability.\n"
      "Examinees differ, so a real study has less. Power rises in a sawtooth: the first number reaches "
      "80 %\n"
      "first, from the last one on no larger study falls below it again.\n");
}

nlohmann::ordered_json json_of(const Plan& plan) {
  const trials::Protocol& protocol = plan.protocol;
  const long each = protocol.trials_per_examinee_per_cell;
  nlohmann::ordered_json cells = nlohmann::ordered_json::array(), rows = nlohmann::ordered_json::array();
  for (const trials::Cell& cell : protocol.cells)
    cells.push_back({{"cell", cell.name}, {"critical", to_json(plan.critical)}});
  const auto people = [each](const std::optional<long>& trials) {
    return trials ? nlohmann::ordered_json(*trials / each) : nlohmann::ordered_json(nullptr);
  };
  for (const PowerRow& row : plan.rows) {
    rows.push_back({{"probability", row.probability},
                    {"d_prime", row.d_prime},
                    {"power", row.power},
                    {"examinees_first", people(row.size.first)},
                    {"examinees_lasting", people(row.size.lasting)},
                    {"sample_size", to_json(row.size)}});
  }
  return {{"protocol", protocol.name},
          {"sha256", protocol.sha256},
          {"planned_examinees", protocol.planned_examinees},
          {"trials_per_examinee_per_cell", each},
          {"trials_per_cell", plan.critical.trials},
          {"primary", protocol.analysis.primary},
          {"alpha", protocol.analysis.alpha},
          {"side", protocol.analysis.side},
          {"cells", cells},
          {"target_power", kTargetPower},
          {"power", rows}};
}

void run(const Options& options) {
  if (!options.freeze.empty()) {
    throw std::invalid_argument(
        "--freeze: writing the analysis plan into a study file is not in this version; the "
        "protocol's own hash is stored with every study");
  }
  const Plan plan = plan_of(options.protocol);
  if (options.format == "json") {
    fmt::print("{}\n", json_of(plan).dump(2));
  } else {
    print_text(plan);
  }
}

}  // namespace

void add_plan(CLI::App& app) {
  const auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("plan", "Critical numbers, power and sample size of a protocol");
  command->add_option("PROTOCOL", options->protocol, "Protocol file")->required();
  command->add_option("--freeze", options->freeze, "Study file to write the plan into (not in this version)");
  add_format(*command, options->format);
  command->footer("Example:\n  palpate plan protocols/kuroda2003.toml\n");
  command->callback([options] { run(*options); });
}

}  // namespace palpate::app
