#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "trials/study/study_file.hpp"
#include "trials/tables/table.hpp"

namespace palpate::trials {

/// What a study file does not know about the data set that is made of it.
struct ExportFacts {
  std::vector<std::string> authors{};
  std::string software_version{};  // that exports
  std::string exported_utc{};
  std::function<void(int done, int total)>
      progress{};  // sittings written; may throw, then nothing is written
};

/// The four tables of a study, checked against their codebook. Throws std::runtime_error, with the first
/// reasons, when one does not hold what the codebook promises.
std::vector<Table> checked_tables(const StudyFile& study, const std::vector<AnsweredTrial>& answered,
                                  const std::vector<Exposure>& exposures);

// Each writes a folder that appears whole or not at all, after it passed the checks below. Throws
// std::invalid_argument when the folder is taken or a name cannot be said in the format, std::system_error
// when the disk refuses, std::runtime_error with the reasons when what was written does not pass.

/// trials.csv, intervals.csv, exposures.csv, events.csv and codebook.csv; beside other files.
void export_csv(const StudyFile& study, const std::filesystem::path& folder);
/// study.json: every table with its codebook; beside other files.
void export_json(const StudyFile& study, const std::filesystem::path& folder);
/// Psych-DS 1.5.
void export_psych_ds(const StudyFile& study, const ExportFacts& facts, const std::filesystem::path& folder);
/// BIDS 1.9, behavioural, with the force traces.
void export_bids(const StudyFile& study, const ExportFacts& facts, const std::filesystem::path& folder);

// The rules of both formats, held against a folder and nothing else. Stricter than the formats' own
// validators; what is wrong, a line each.
std::vector<std::string> check_psych_ds(const std::filesystem::path& folder);
std::vector<std::string> check_bids(const std::filesystem::path& folder);

}  // namespace palpate::trials
