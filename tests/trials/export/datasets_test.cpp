#include "trials/export/datasets.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/trials/export/exported_study.hpp"
#include "tests/trials/support/raw_sql.hpp"
#include "trials/export/words.hpp"

namespace palpate::trials {
namespace {

using nlohmann::json;
using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr const char* kSitting = "sub-P01/ses-1/beh/sub-P01_ses-1_task-kuroda2003";

/// A change to a file of a valid data set, and what the checks must then say. An empty `from` writes the
/// whole file, or deletes it where `to` is empty as well.
struct Broken {
  std::string file, from, to, says;
};

class Datasets : public test::ExportedStudy {
 protected:
  /// Breaks the exported data set in each way, one after the other, and restores it.
  template <class Check>
  void expect_found(const std::vector<Broken>& ways, Check check) const {
    for (const auto& [name, from, to, says] : ways) {
      const std::filesystem::path file = folder_ / "out" / name;
      const bool is_new = !std::filesystem::exists(file);
      const std::string before = is_new ? "" : test::read(file);
      if (!from.empty())
        test::write(file, test::with(before, from, to));
      else if (to.empty())
        std::filesystem::remove(file);
      else
        test::write(file, to);
      EXPECT_THAT(check(folder_ / "out"), Contains(HasSubstr(says))) << name << ": " << from << " -> " << to;
      if (is_new)
        std::filesystem::remove(file);
      else
        test::write(file, before);
    }
    EXPECT_THAT(check(folder_ / "out"), IsEmpty());
  }
};

TEST_F(Datasets, PassTheirOwnChecks) {
  export_psych_ds(study_, facts_, folder_ / "psych-ds");
  EXPECT_THAT(check_psych_ds(folder_ / "psych-ds"), IsEmpty());
  export_bids(study_, facts_, folder_ / "bids");
  EXPECT_THAT(check_bids(folder_ / "bids"), IsEmpty());
}

TEST_F(Datasets, HoldEveryRowAndMarkItsRunMode) {
  export_psych_ds(study_, facts_, folder_ / "out");
  const std::string trials = test::read(folder_ / "out/data/study-kuroda2003_description-trials_data.csv");
  EXPECT_EQ(std::ranges::count(trials, '\n'), 1 + 3 * 4);
  EXPECT_THAT(trials, HasSubstr("P-01,1,1,1,pilot,"));
  EXPECT_THAT(trials, HasSubstr("P-01,2,1,1,study,"));
  const std::string others = test::read(folder_ / "out/data/study-kuroda2003_description-exposures_data.csv");
  EXPECT_EQ(std::ranges::count(others, '\n'), 1 + 3);
  EXPECT_THAT(test::read(folder_ / "out/dataset_description.json"), HasSubstr("3 study, 1 pilot"));
}

TEST_F(Datasets, SayWhenNothingInThemIsAResult) {
  StudyFile simulated = open_study(folder_ / "simulated.db", protocol_, "0.1.0");
  Session session = start_session(simulated, protocol_, test::facts_of("S1", RunMode::Simulated));
  test::answer_all(session);
  export_bids(simulated, facts_, folder_ / "out");
  EXPECT_THAT(test::read(folder_ / "out/dataset_description.json"), HasSubstr("NO RESULT OF A STUDY"));
  EXPECT_THAT(test::read(folder_ / "out/participants.tsv"), HasSubstr("sub-S1\tS1\t1\tsimulated\n"));
}

// No column holds it: it is the same for every answer.
TEST(CourseInWords, TellsOfFeedback) {
  Protocol protocol = test::small_protocol();
  const std::string plain = describe_course(protocol);
  EXPECT_EQ(plain, protocol.task->course_in_words(protocol));
  protocol.feedback = true;
  EXPECT_EQ(describe_course(protocol),
            plain + " After each answer the examinee is told whether it was right.");
}

TEST_F(Datasets, KeepAwkwardTextReadable) {
  export_bids(study_, facts_, folder_ / "bids");
  EXPECT_THAT(test::read(folder_ / "bids" / (std::string(kSitting) + "_beh.tsv")),
              HasSubstr("\t1\tthe \"alarm\" rang; \\ \"twice\\ \", and \xEF\xBF\xBD a door\n"));
}

TEST_F(Datasets, HaveWhatExamineesWrote) {
  export_csv(study_, folder_ / "csv");
  export_json(study_, folder_ / "json");
  export_bids(study_, facts_, folder_ / "bids");
  export_psych_ds(study_, facts_, folder_ / "psych-ds");
  const std::string csv = "P-01,2,n/a,strategy,\"the \"\"softer\"\" one, I think\",";
  EXPECT_THAT(test::read(folder_ / "csv/events.csv"), HasSubstr(csv));
  EXPECT_THAT(test::read(folder_ / "csv/codebook.csv"), HasSubstr("events,event_text,Text of the event,"));
  EXPECT_THAT(test::read(folder_ / "psych-ds/data/study-kuroda2003_description-events_data.csv"),
              HasSubstr(csv));
  const json events = json::parse(test::read(folder_ / "json/study.json")).at("events").at("rows");
  EXPECT_EQ(events.back().at("event_text"), "the \"softer\" one, I think");
  EXPECT_THAT(test::read(folder_ / "bids/sub-P01/ses-2/beh/sub-P01_ses-2_task-kuroda2003_acq-events_beh.tsv"),
              HasSubstr("sub-P01\tses-2\tn/a\tstrategy\tthe \"softer\" one, I think\t"));
}

TEST_F(Datasets, NameEveryVersionThatLedASitting) {
  SessionFacts newer = test::facts_of("R3");
  newer.software_version = "0.2.0";
  start_session(study_, protocol_, newer);  // takes up the one that was killed
  export_bids(study_, facts_, folder_ / "out");
  const auto sidecar = json::parse(
      test::read(folder_ / "out/sub-R3/ses-1/beh/sub-R3_ses-1_task-kuroda2003_acq-events_beh.json"));
  EXPECT_EQ(sidecar.at("SoftwareVersion"), "0.1.0");
  EXPECT_EQ(sidecar.at("LaterSoftwareVersions"), json::array({"0.2.0"}));
}

TEST_F(Datasets, HaveTheForceOfEveryPresentation) {
  export_bids(study_, facts_, folder_ / "out");
  const auto sidecar =
      json::parse(test::read(folder_ / "out" / (std::string(kSitting) + "_recording-force_physio.json")));
  EXPECT_EQ(sidecar.at("SamplingFrequency"), 1000);  // press_to() has a sample each millisecond
  EXPECT_EQ(sidecar.at("force_z_n").at("Units"), "N");
  EXPECT_EQ(sidecar.at("RunMode"), "pilot");
  // What is in the file, by another program's hand.
  const std::string counted =
      "gunzip -c '" +
      (folder_ / "out" / (std::string(kSitting) + "_recording-force_physio.tsv.gz")).string() +
      "' | awk '$5 == 1 { n++; if ($14 < least) least = $14 } END { print n, least }' > '" +
      (folder_ / "awk").string() + "'";
  ASSERT_EQ(std::system(counted.c_str()), 0);
  EXPECT_EQ(test::read(folder_ / "awk"), "808 -0.4\n");  // 8 intervals of 101 samples; 100 N/m, 4 mm deep
}

TEST_F(Datasets, TheJsonHasTheCodebookBesideTheDescriptions) {
  export_json(study_, folder_ / "out");
  const json exported = json::parse(test::read(folder_ / "out/study.json"));
  const json& trials = exported.at("trials");
  EXPECT_EQ(trials.at("columns").size(), trials.at("codebook").size());
  EXPECT_EQ(trials.at("codebook").at("response_time_s").at("unit"), "s");
  EXPECT_EQ(trials.at("codebook").at("response").at("maximum"), 2);
  EXPECT_THAT(
      exported.at("intervals").at("codebook").at("condition").at("levels").at("hard").get<std::string>(),
      HasSubstr("5.0 MPa"));
}

TEST_F(Datasets, AnEmptyStudyIsRefusedAndLeavesNothing) {
  const StudyFile empty = open_study(folder_ / "empty.db", protocol_, "0.1.0");
  EXPECT_THROW(export_bids(empty, facts_, folder_ / "x/out"), std::invalid_argument);
  EXPECT_THROW(export_psych_ds(empty, facts_, folder_ / "x/out"), std::invalid_argument);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "x"));
}

TEST_F(Datasets, ACodeWithoutLetterOrDigitIsRefused) {
  StudyFile odd = open_study(folder_ / "odd.db", protocol_, "0.1.0");
  Session session = start_session(odd, protocol_, test::facts_of("P01"));
  test::answer_all(session);
  // Codes of hyphens were accepted by the first version.
  ASSERT_EQ(test::sql(folder_ / "odd.db",
                      "DROP TRIGGER session_refuses_UPDATE; UPDATE session SET examinee = '--'"),
            "");
  EXPECT_THAT(test::message_of<std::invalid_argument>([&] { export_bids(odd, facts_, folder_ / "out"); }),
              HasSubstr("\"--\" has neither letter nor digit"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "out"));
}

constexpr const char* kJson = "dataset_description.json";

TEST_F(Datasets, EveryRuleOfPsychDsIsHeld) {
  const std::string kTrials = "data/study-kuroda2003_description-trials_data.csv";
  export_psych_ds(study_, facts_, folder_ / "out");
  expect_found(
      {{kJson, "", "", "dataset_description.json: is missing"},
       {kJson, "\"Dataset\"", "\"dataset\"", "@type is not Dataset"},
       {kJson, "https://schema.org", "schema.org", "@context is not"},
       {kJson, "\"name\": \"palpate study", "\"title\": \"palpate study", "name is missing"},
       {kJson, "\"name\": \"block\"", "\"name\": \"blok\"", "block is not described"},
       {kJson, "\"name\": \"block\"", "\"name\": \"blok\"", "blok is described and stands in no file"},
       {kJson, "\"name\": \"block\"", "\"name\": \"trial\"", "trial: is described twice"},
       {kJson, "\"unitText\": \"N\"", "\"unitText\": \"mN\"", "unitText \"mN\""},
       {kJson, "^(0|1)$", "^(0|1", "no regular expression"},
       {kJson, "{\n  \"@context\"", "{\n  \"@type\": 1,\n  \"@context\"", "stands twice"},
       {kTrials, "participant_id,session_id", "\xEF\xBB\xBFparticipant_id,session_id", "byte-order mark"},
       {kTrials, "participant_id,session_id", "participant_id,participant_id", "stands twice"},
       {kTrials, "participant_id,session_id", "participant_id,Session", "is not snake_case"},
       {kTrials, ",0,n/a\n", ",0,n/a,\n", "ends with a delimiter"},
       {kTrials, ",0,n/a\n", ",0\n", "has 18 cells of 19"},
       {kTrials, ",0,n/a\n", ",0,n/a\n\n", "is blank"},
       {kTrials, ",0,n/a\n", ",0,n/a\r\n", "carriage return"},
       {kTrials, ",0,n/a\n", ",,n/a\n", "has an empty cell"},
       {kTrials, ",0,n/a\n", ",0,a \\\"b\\\"\n", "a backslash before it"},
       {kTrials, ",0,n/a\n", ",0,a\"b\"\n", "a quote stands in the wrong place"},
       {kTrials, ",pilot,", ",rehearsal,", "\"rehearsal\" does not fit"},
       {kTrials, ",0.8,", ",0.8 s,", "\"0.8 s\" is no number"},
       {kTrials, ",0.8,", ",-0.8,", "is out of range"},
       Broken{kTrials, ",", ";", "is not snake_case"},
       {"data/study-k_Trials_data.csv", "", "a\n1\n", "the name is not keyword-value"},
       {"data/study-k_examinee-P01_data.csv", "", "trial\n1\n", "examinee is no keyword"},
       {"data/subject-P01_data.csv", "", "trial\n", "has no rows"},
       {"data/subject-P01_data.csv", "", "trial\n1", "the last line has no end"},
       {"data/subject-P01_data.csv", "", "device\n\xC0\x80\n", "is not UTF-8"}},
      check_psych_ds);
}

TEST_F(Datasets, EveryRuleOfBidsIsHeld) {
  const std::string kBeh = std::string(kSitting) + "_beh.tsv", kSidecar = std::string(kSitting) + "_beh.json";
  const std::string kForce = std::string(kSitting) + "_recording-force_physio.tsv.gz",
                    kForceJson = std::string(kSitting) + "_recording-force_physio.json";
  export_bids(study_, facts_, folder_ / "out");
  expect_found(
      {{kJson, "1.9.0", "nine", "BIDSVersion is not"},
       {kJson, "\"A. Author\"", "1", "Authors is no list of names"},
       {"participants.tsv", "participant_id\texaminee_code", "examinee_code\tparticipant_id",
        "participant_id is not the first column"},
       {"participants.tsv", "sub-Q2", "Q2", "is not sub-LABEL"},
       {"participants.tsv", "sub-Q2\tQ2", "sub-Q3\tQ3", "does not name just the subjects"},
       {"participants.json", "n_sittings", "sittings", "n_sittings is not described"},
       {"notes.txt", "", "mine", "does not belong into a BIDS data set"},
       {kSidecar, "", "", "_beh.json: is missing"},
       Broken{kBeh, "", "", "has no data file beside it"},
       {kSidecar, "\"TaskName\": \"kuroda2003\"", "\"TaskName\": \"other\"", "TaskName is not that of"},
       {kSidecar, "\"Instructions\"", "\"instructions\"", "Instructions is missing"},
       {kSidecar, "\"block\"", "\"blok\"", "blok is described and is no column"},
       {kSidecar, "\"LongName\": \"Block\",", "", "LongName is missing"},
       {kSidecar, "\"Units\": \"s\"", "\"Units\": \"ms\"", "Units is not s"},
       {kBeh, "\t", ",", "is not snake_case"},
       Broken{kBeh, "\tpilot\t", "\t\t", "has an empty cell"},
       {kBeh, "\tpilot\t", "\tfree\t", "\"free\" does not fit"},
       {kBeh, "\tmouse\t", "\t\"mouse\"\t", "a quote stands in the wrong place"},
       {kForce, "", "not gzip\n", "is no whole gzip file"},
       {kForceJson, "1000", "0", "SamplingFrequency is no positive number"},
       {kForceJson, "\"StartTime\": 0", "\"StartTime\": \"0\"", "StartTime is no number"},
       {kForceJson, "    \"force_z_n\"\n", "    \"force_z_n\", \"more\"\n", "has 14 cells of 15"},
       {kForceJson, "\"Units\": \"N\"", "\"Units\": \"kg\"", "Units \"kg\""},
       {"sub-P01/ses-1/beh/sub-P01_ses-2_task-kuroda2003_beh.tsv", "", "a\n1\n", "is not the folder's"},
       {"sub-P01/ses-1/beh/sub-P01_ses-1_beh.tsv", "", "a\n1\n", "is no name of a behavioural file"}},
      check_bids);
}

}  // namespace
}  // namespace palpate::trials
