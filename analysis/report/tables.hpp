#pragma once

#include <string>
#include <vector>

#include "analysis/report/report.hpp"

namespace palpate::analysis {

/// A table of a report, in words, for whichever writer lays it out. The first column names the row.
struct TextTable {
  std::string title{};
  std::vector<std::string> header{};
  std::vector<std::vector<std::string>> rows{};
  std::string note{};
};

/// Who has answered how often, while results are withheld.
TextTable answers_table(const StudyReport& report);
TextTable verdict_table(const StudyReport& report);        // a line for each cell
TextTable primary_table(const StudyReport& report);        // answers, critical number, p, interval
TextTable evidence_table(const StudyReport& report);       // where no difference is shown; may be empty
TextTable people_table(const StudyReport& report);         // examinee-level test
TextTable comparison_table(const StudyReport& report);     // planned ones first
TextTable sensitivity_table(const StudyReport& report);    // d' and answers by interval order
TextTable learning_table(const StudyReport& report);       // empty where nobody answered twice
TextTable examinee_table(const StudyReport& report);       // counts of each examinee
TextTable response_time_table(const StudyReport& report);  // empty where none were recorded
TextTable stimulus_table(const StudyReport& report);
TextTable voided_table(const StudyReport& report);
TextTable session_table(const StudyReport& report);
TextTable curve_table(const StudyReport& report);  // the data behind the force curves

}  // namespace palpate::analysis
