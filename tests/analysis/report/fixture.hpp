#pragma once

#include <string>
#include <vector>

#include "analysis/report/report.hpp"
#include "analysis/report/study_table.hpp"

namespace palpate::analysis::test {

/// The 2003 study as a table: soft against hard under kuroda and sibille, four trials of each for an
/// examinee. correct[e][c] of examinee e's trials under cell c are answered correctly. The harder interval
/// comes first in every other trial, so that every figure in the report can be worked out by hand.
inline StudyTable study_table(const std::vector<std::vector<int>>& correct, int trials = 4,
                              const std::string& run_mode = "study") {
  StudyTable table;
  table.design = {
      .protocol_name = "kuroda2003",
      .protocol_sha256 = std::string(64, 'a'),
      .protocol_text = "name = \"kuroda2003\"\nquestion = \"In which interval did it feel harder?\"\n",
      .question = "In which interval did it feel harder?",
      .conditions = {"soft", "hard"},
      .correct_condition = "hard",
      .factors = {"contact.model"},
      .cells = {{"kuroda", {"kuroda"}}, {"sibille", {"sibille"}}},
      .trials_per_examinee_per_cell = trials,
      .planned_examinees = 15,
      .least_presses = 1,
      .most_presses = 5,
      .min_depth_m = 0.003,
      .max_time_s = 10,
      .display_during_interval = "hidden",
      .between_models = "sign-flip"};
  for (std::size_t e = 0; e < correct.size(); ++e) {
    const std::string number = std::to_string(e + 1);
    table.sessions.push_back({.examinee = (e < 9 ? "P0" : "P") + number,
                              .run_mode = run_mode,
                              .protocol_sha256 = table.design.protocol_sha256,
                              .software_version = "0.1.0",
                              .device = run_mode == "simulated" ? "simulated observer" : "Touch",
                              .order_source = "operating system",
                              .started_utc = "2003-12-03T09:30:00Z",
                              .finished = true});
    int trial = 0;
    for (std::size_t cell = 0; cell < correct[e].size(); ++cell) {
      for (int t = 0; t < trials; ++t) {
        const bool first = t % 2 == 0, right = t < correct[e][cell];
        TrialRow row{.session = e,
                     .cell = cell,
                     .trial = ++trial,
                     .correct_answer = first ? "1" : "2",
                     .response = first == right ? "1" : "2",
                     .correct = right,
                     .response_time_s = 1.5};
        for (int i = 1; i <= 2; ++i) {
          row.intervals.push_back({.interval = i,
                                   .condition = (i == 1) == first ? "hard" : "soft",
                                   .n_presses = 2,
                                   .exploration_time_s = 4.0,
                                   .peak_force_n = 1.25,
                                   .max_depth_m = 0.004,
                                   .clamped_fraction = 0.0});
        }
        table.trials.push_back(row);
      }
    }
  }
  return table;
}

/// 52 of 60 correct under kuroda, 31 of 60 under sibille.
inline std::vector<std::vector<int>> like_the_paper() {
  return {{4, 2}, {4, 3}, {3, 2}, {4, 1}, {4, 2}, {3, 3}, {4, 2}, {2, 1},
          {4, 2}, {4, 3}, {3, 2}, {4, 2}, {2, 3}, {4, 1}, {3, 2}};
}

/// Curves as Fig. 8 has them: under kuroda the conditions part, under sibille they coincide.
inline void add_curves(StudyTable& table, const std::string& run_mode = "study") {
  for (std::size_t cell = 0; cell < 2; ++cell) {
    for (const std::string condition : {"soft", "hard"}) {
      ForceCurve curve{.cell = cell, .condition = condition, .run_mode = run_mode, .intervals = 60};
      for (int i = 0; i <= 20; ++i) {
        const double depth = 0.00025 * i;
        const double slope = cell == 0 && condition == "hard" ? 420 : 300;
        curve.depth_m.push_back(depth);
        curve.mean_force_n.push_back(slope * depth * (1 + 60 * depth));
        curve.deviation_n.push_back(0.04 * curve.mean_force_n.back());
      }
      table.curves.push_back(curve);
    }
  }
}

}  // namespace palpate::analysis::test
