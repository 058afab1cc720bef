#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "app/commands/commands.hpp"
#include "app/output.hpp"
#include "app/study_plan.hpp"

namespace palpate::app {
namespace {

struct Options {
  std::string protocol, freeze, format;
  double overdispersion = 0.0;
};

void run(const Options& options) {
  const trials::Protocol protocol = trials::load_protocol(options.protocol);
  const StudyPlan plan = study_plan(protocol, options.overdispersion);
  const std::string frozen = options.freeze.empty() ? "" : freeze_plan(protocol, options.freeze);
  if (options.format == "json") {
    nlohmann::ordered_json json = to_json(plan);
    if (!frozen.empty()) json["frozen"] = {{"study", options.freeze}, {"sha256", frozen}};
    fmt::print("{}\n", json.dump(2));
    return;
  }
  fmt::print("{}", in_words(plan));
  if (!frozen.empty()) fmt::print("\nThe plan is frozen in {}, SHA-256 {}\n", options.freeze, frozen);
}

}  // namespace

void add_plan(CLI::App& app) {
  const auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("plan", "Critical numbers, power and sample size of a protocol");
  command->add_option("PROTOCOL", options->protocol, "Protocol file")->required();
  command
      ->add_option("--overdispersion", options->overdispersion,
                   "How unlike examinees are, 0 (all alike) to 1: gamma of a beta-binomial distribution")
      ->capture_default_str();
  command->add_option(
      "--freeze", options->freeze,
      "Write the analysis plan into this study file, before the first answer; the report then says "
      "what deviates from it");
  add_format(*command, options->format);
  command->footer(
      "Examples:\n"
      "  palpate plan protocols/kuroda2003.toml --overdispersion 0.1\n"
      "  palpate plan protocols/kuroda2003.toml --freeze study.db\n");
  command->callback([options] { run(*options); });
}

}  // namespace palpate::app
