// BIDS 1.9, behavioural: participants, and for every sitting a table of answers, one of intervals, one of
// what did not count, one of what was noted, and the force as it was felt.
#include <fmt/format.h>

#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>

#include "base/files/new_folder.hpp"
#include "trials/export/bids_physio.hpp"
#include "trials/export/datasets.hpp"
#include "trials/export/json_number.hpp"
#include "trials/export/words.hpp"
#include "trials/study/resumption.hpp"
#include "trials/tables/delimited.hpp"

namespace palpate::trials {
namespace {

using nlohmann::ordered_json;
using SittingKey = std::pair<std::string, std::int64_t>;  // examinee, number of the sitting

ordered_json described(const Column& column) {
  ordered_json object = {{"LongName", column.title}, {"Description", column.description}};
  for (const Level& level : column.levels) object["Levels"][level.value] = level.meaning;
  if (!column.unit.empty()) object["Units"] = column.unit;
  if (column.least) object["Minimum"] = json_number(*column.least);
  if (column.most) object["Maximum"] = json_number(*column.most);
  return object;
}

void add_columns(ordered_json& object, const std::vector<Column>& columns) {
  for (const Column& column : columns) object[column.name] = described(column);
}

/// The columns and values that BIDS names itself: response_time, sub-P01, ses-1.
Table as_bids(Table table) {
  for (Column& column : table.columns)
    if (column.name == "response_time_s") column.name = "response_time";
  for (auto& row : table.rows)
    for (std::size_t i = 0; i < row.size(); ++i) {
      if (table.columns[i].name == "participant_id")
        row[i] = "sub-" + label_of(std::get<std::string>(row[i]));
      if (table.columns[i].name == "session_id")
        row[i] = fmt::format("ses-{}", std::get<std::int64_t>(row[i]));
    }
  for (Column& column : table.columns) {
    if (column.name == "session_id") column.kind = Kind::Text, column.least.reset();
    if (column.name == "session_id") column.description = "The examinee's sitting, as in the folder's name";
    if (column.name == "participant_id") column.description = "The examinee, as in participants.tsv";
  }
  return table;
}

/// The rows of every sitting; in all tables the first two columns name it.
std::map<SittingKey, Table> by_sitting(const Table& table) {
  std::map<SittingKey, Table> parts;
  for (const auto& row : table.rows) {
    const SittingKey key{std::get<std::string>(row[0]), std::get<std::int64_t>(row[1])};
    Table& part = parts[key];
    if (part.columns.empty()) part = {.name = table.name, .columns = table.columns};
    part.rows.push_back(row);
  }
  for (auto& [key, part] : parts) part = as_bids(std::move(part));
  return parts;
}

/// @param later  versions of the program that took the sitting up again
ordered_json sidecar_of(const Protocol& protocol, const SessionRow& session,
                        const std::vector<std::string>& later) {
  const SessionFacts& facts = session.facts;
  ordered_json object = {
      {"TaskName", protocol.name},
      {"TaskDescription", describe_course(protocol)},
      {"Instructions", protocol.question},
      {"RunMode", to_string(facts.run_mode)},
      {"Device", plain_text(facts.device)},
      {"PseudoHaptic", facts.pseudo_haptic},
      {"ForceScale", facts.force_scale},
      {"OrderSeed", facts.seed ? fmt::format("{}", *facts.seed) : "operating system's entropy"},
      {"Machine", plain_text(facts.machine)},
      {"SoftwareName", "palpate"},
      {"SoftwareVersion", facts.software_version},
      {"ProtocolSHA256", protocol.sha256},
      {"Started", session.started_utc},
      {"TimesResumed", session.times_resumed},
      {"Finished", session.ended_utc.has_value()}};
  if (!later.empty()) object["LaterSoftwareVersions"] = later;
  if (!facts.channel.empty()) object["PseudoHapticChannel"] = facts.channel;
  return object;
}

/// Writes one data set into a folder, sitting by sitting.
class Writer {
 public:
  Writer(const StudyFile& study, const ExportFacts& facts, base::NewFolder& files)
      : study_(study),
        facts_(facts),
        files_(files),
        task_(label_of(study.protocol().name)),
        events_(study.events()) {
    const auto answered = answered_trials(study);
    const auto unanswered = exposures(study);
    for (const Table& table : checked_tables(study, answered, unanswered))
      tables_.push_back(by_sitting(table));
    felt_ = felt_by_sitting(answered, unanswered);
  }

  void write() {
    const auto sessions = study_.sessions();
    for (std::size_t i = 0; i < sessions.size(); ++i) {
      add_sitting(sessions[i]);
      if (facts_.progress) facts_.progress(static_cast<int>(i + 1), static_cast<int>(sessions.size()));
    }
    if (sittings_.empty())
      throw std::invalid_argument(
          "the study holds nothing yet that was felt or answered; BIDS wants at least one data file");
    add_participants();
    add_description();
    files_.add("README.md", readme());
    files_.add("CHANGES", changes_text(study_, facts_));
    files_.add("sourcedata/protocol.toml", study_.study().protocol_text);
    files_.add("sourcedata/scene.toml", study_.study().scene_text);
  }

 private:
  void add_json(const std::string& file, const ordered_json& object) {
    files_.add(file, object.dump(2) + "\n");
  }

  void add_sitting(const SessionRow& session) {
    constexpr std::array<const char*, 4> kAcquisition{"", "_acq-intervals", "_acq-exposures", "_acq-events"};
    const std::string subject = "sub-" + label_of(session.facts.examinee);
    const std::string sitting = fmt::format("{}_ses-{}", subject, session.number);
    const std::string stem = fmt::format("{}/ses-{}/beh/{}_task-{}", subject, session.number, sitting, task_);
    bool any = false;
    for (std::size_t i = 0; i < tables_.size(); ++i) {
      const auto part = tables_[i].find({session.facts.examinee, session.number});
      if (part == tables_[i].end()) continue;
      any = true;
      files_.add(fmt::format("{}{}_beh.tsv", stem, kAcquisition[i]), to_tsv(part->second));
      ordered_json object =
          sidecar_of(study_.protocol(), session, versions_that_resumed(events_, session.id));
      add_columns(object, part->second.columns);
      add_json(fmt::format("{}{}_beh.json", stem, kAcquisition[i]), object);
    }
    if (!any) return;
    sittings_[session.facts.examinee].push_back(session);
    add_force(stem + "_recording-force_physio", session);
  }

  void add_force(const std::string& stem, const SessionRow& session) {
    const auto frequency = write_physio(study_, felt_[session.id], files_.aside() / (stem + ".tsv.gz"));
    if (!frequency) return;
    ordered_json object = {{"SamplingFrequency", *frequency},
                           {"StartTime", 0},
                           {"Columns", ordered_json::array()},
                           {"RecordingDescription",
                            "Presentations one after the other; between them nothing was recorded. time_s "
                            "begins anew with each; trial, interval and counted = 1 lead to the row of the "
                            "table acq-intervals."}};
    for (const Column& column : physio_columns()) object["Columns"].push_back(column.name);
    object.update(sidecar_of(study_.protocol(), session, versions_that_resumed(events_, session.id)));
    add_columns(object, physio_columns());
    add_json(stem + ".json", object);
  }

  void add_participants() {
    Table table{.name = "participants"};
    table.columns = {
        {.name = "participant_id",
         .title = "Examinee",
         .description = "The examinee, as in the folders' names"},
        {.name = "examinee_code", .title = "Code", .description = "Code of the examinee in the study file"},
        {.name = "n_sittings",
         .title = "Sittings",
         .description = "Number of sittings",
         .kind = Kind::Whole,
         .least = 1},
        {.name = "run_modes",
         .title = "Run modes",
         .description =
             "What the sittings were held for: study, pilot, practice or simulated (no person took "
             "part), joined by +"}};
    for (const auto& [examinee, sittings] : sittings_) {
      std::set<std::string> modes;
      for (const SessionRow& session : sittings) modes.emplace(to_string(session.facts.run_mode));
      table.rows.push_back({"sub-" + label_of(examinee), examinee, static_cast<std::int64_t>(sittings.size()),
                            fmt::format("{}", fmt::join(modes, "+"))});
    }
    files_.add("participants.tsv", to_tsv(table));
    ordered_json object;
    add_columns(object, table.columns);
    add_json("participants.json", object);
  }

  void add_description() {
    add_json(
        "dataset_description.json",
        {{"Name", "palpate study " + study_.protocol().name},
         {"BIDSVersion", "1.9.0"},
         {"DatasetType", "raw"},
         {"Authors", facts_.authors},
         {"Description", describe_dataset(study_)},
         {"Keywords", {"haptics", "psychophysics", "forced choice"}},
         {"GeneratedBy",
          {{{"Name", "palpate"}, {"Version", facts_.software_version}, {"Description", "palpate export"}}}},
         {"StudyFile", study_.study().uuid},
         {"Receipt", to_string(study_.receipt())}});
  }

  std::string readme() const {
    const Protocol& protocol = study_.protocol();
    std::string text = fmt::format(
        "# {0}\n\n{1}\n\n{2}\nThe question: {3}\n\n"
        "A BIDS data set, written by palpate. For every sitting, in `sub-*/ses-*/beh/`:\n\n"
        "- `*_task-{4}_beh.tsv`: one row an answer\n"
        "- `*_task-{4}_acq-intervals_beh.tsv`: one row an interval of an answered question\n"
        "- `*_task-{4}_acq-exposures_beh.tsv`: one row a presentation that did not count, where there was "
        "one\n"
        "- `*_task-{4}_recording-force_physio.tsv.gz`: depth and force as felt, sample by sample; its JSON "
        "file names the columns\n\n"
        "Each file has its columns described in the JSON file beside it. Missing values are `n/a`. Points in "
        "time are UTC. `sourcedata/` holds the protocol and the scene as they were run.\n",
        protocol.name, describe_dataset(study_), describe_course(protocol), protocol.question, task_);
    text += fmt::format("\n## Columns of the answers\n\n{}",
                        codebook_markdown(as_bids({.name = "trials", .columns = trial_columns(protocol)})));
    text +=
        fmt::format("\n## Columns of the intervals\n\n{}",
                    codebook_markdown(as_bids({.name = "intervals", .columns = interval_columns(protocol)})));
    return text;
  }

  const StudyFile& study_;
  const ExportFacts& facts_;
  base::NewFolder& files_;
  std::string task_;
  std::vector<EventRow> events_;
  std::vector<std::map<SittingKey, Table>> tables_{};
  std::map<std::int64_t, std::vector<Felt>> felt_{};
  std::map<std::string, std::vector<SessionRow>> sittings_{};
};

}  // namespace

void export_bids(const StudyFile& study, const ExportFacts& facts, const std::filesystem::path& folder) {
  base::NewFolder files(folder, base::NewFolder::Beside::Nothing);
  Writer(study, facts, files).write();
  refuse_problems("the BIDS data set", check_bids(files.aside()));
  files.finish();
}

}  // namespace palpate::trials
