#include "app/commands/export/export.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "app/command_line/interrupt.hpp"
#include "app/command_line/progress.hpp"
#include "base/clock/utc.hpp"
#include "trials/export/datasets.hpp"
#include "trials/study/verify.hpp"

namespace palpate::app {
namespace {

struct ExportOptions {
  std::string study, as, out;
  std::vector<std::string> authors;
};

void run_export(const ExportOptions& options) {
  trials::require_whole(options.study);
  const trials::StudyFile study = trials::read_study(options.study);
  trials::ExportFacts facts{
      .authors = options.authors, .software_version = PALPATE_VERSION, .exported_utc = base::utc_now()};
  if (options.as == "csv") return trials::export_csv(study, options.out);
  if (options.as == "json") return trials::export_json(study, options.out);
  if (options.authors.empty())
    fmt::print(stderr,
               "No authors given (--author): add them to dataset_description.json before you share it\n");
  if (options.as == "psych-ds") return trials::export_psych_ds(study, facts, options.out);
  catch_interrupts();  // what was written aside is taken away
  ProgressBar bar("sittings");
  facts.progress = [&bar](int done, int total) {
    if (interrupted()) throw Interrupted();
    bar.show(done, total);
  };
  trials::export_bids(study, facts, options.out);
}

std::vector<std::string> written(const ExportOptions& options) {
  if (options.as == "csv") return {"trials.csv", "intervals.csv", "exposures.csv", "codebook.csv"};
  if (options.as == "json") return {"study.json"};
  return {""};
}

void add_export(CLI::App& command) {
  auto options = std::make_shared<ExportOptions>();
  command.add_option("study", options->study, "Study file")->required();
  command.add_option("--as", options->as, "Format")
      ->required()
      ->check(CLI::IsMember({"csv", "json", "psych-ds", "bids"}));
  command
      .add_option(
          "--out", options->out,
          "Folder for the files; nothing in it is overwritten. A psych-ds or bids data set wants a folder "
          "of its own")
      ->required();
  command.add_option("--author", options->authors, "Author of a psych-ds or bids data set; once for each")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  command.footer(
      "csv: trials (one row an answer), intervals (what was felt before it), exposures (what was shown but "
      "did\n"
      "not count), codebook (what each column means). json: the same in one file. psych-ds, bids: data sets\n"
      "to share; bids has the force of every interval, sample by sample. All are checked before they "
      "appear,\n"
      "and appear whole or not at all. The column run_mode marks pilot, practice and simulated sittings.\n\n"
      "Example:\n"
      "  palpate export study.db --as csv --out exported\n"
      "  palpate export study.db --as bids --out exported-bids --author 'A. Author' --author 'B. Author'\n");
  command.callback([options] {
    run_export(*options);
    for (const std::string& file : written(*options))
      fmt::print("{}\n", (std::filesystem::path(options->out) / file).string());
  });
}

}  // namespace

const Command export_command{.name = "export",
                             .summary = "Writes the trial log for other tools",
                             .heading = "Read a study",
                             .add = add_export};

}  // namespace palpate::app
