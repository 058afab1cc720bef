#include "app/commands/merge/merge.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/command_line/output.hpp"
#include "app/study/merged_parts_json.hpp"
#include "base/text/counted.hpp"
#include "trials/study/merge.hpp"

namespace palpate::app {
namespace {

struct MergeOptions {
  std::string out, format;
  std::vector<std::string> files, sites;
};

std::vector<trials::MergeSource> sources_of(const MergeOptions& options) {
  std::vector<trials::MergeSource> sources;
  for (const std::string& file : options.files) sources.push_back({.file = file});
  for (const std::string& site : options.sites) {
    const std::size_t equals = site.find('=');
    if (equals == 0 || equals == std::string::npos || equals + 1 == site.size())
      throw std::invalid_argument(fmt::format("--site: found \"{}\", accepted: NAME=FILE", site));
    sources.push_back({.file = site.substr(equals + 1), .site = site.substr(0, equals)});
  }
  return sources;
}

void run_merge(const MergeOptions& options) {
  trials::merge_studies(options.out, sources_of(options), PALPATE_VERSION);
  const trials::StudyFile study = trials::read_study(options.out);
  const auto parts = trials::merged_parts(study.events());
  if (options.format == "json") {
    print_json({{"study", options.out},
                {"parts", parts_json(parts)},
                {"receipt", trials::to_string(study.receipt())}});
    return;
  }
  fmt::print("{}: {} of {} study files\n", options.out,
             base::counted(std::ssize(study.sessions()), "sitting", "sittings"), parts.size());
  for (const trials::MergedPart& part : parts)
    fmt::print("  {}{}: {}, receipt {}\n", part.file,
               part.site.empty() ? "" : fmt::format(" (site {})", part.site),
               base::counted(part.sessions, "sitting", "sittings"), trials::to_string(part.receipt));
  fmt::print("receipt {}\n", trials::to_string(study.receipt()));
}

void add_merge(CLI::App& command) {
  auto options = std::make_shared<MergeOptions>();
  command.add_option("out", options->out, "The new study file; nothing is overwritten")->required();
  command.add_option("studies", options->files,
                     "Study files of one protocol, with examinees of different codes");
  command
      .add_option(
          "--site", options->sites,
          "NAME=FILE: a study file whose examinees' codes get the site's name before them; once for each")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  add_format(command, options->format);
  command.footer(
      "The files must be whole, of one protocol, scene and meshes; they are only read. Where two sites used\n"
      "the same codes, name the sites: P01 of Osaka becomes Osaka-P01. The chains of answers are kept as "
      "they\n"
      "are: palpate verify holds for the new file, and the receipts of all sittings stay good for it.\n\n"
      "Example:\n"
      "  palpate merge all.db osaka.db kyoto.db\n"
      "  palpate merge all.db --site Osaka=osaka.db --site Kyoto=kyoto.db\n");
  command.callback([options] { run_merge(*options); });
}

}  // namespace

const Command merge_command{.name = "merge",
                            .summary = "Joins study files of several sites into a new one",
                            .heading = "Read a study",
                            .add = add_merge};

}  // namespace palpate::app
