#include "analysis/report/withhold.hpp"

namespace palpate::analysis {
namespace {

void withhold(std::vector<ExamineeCount>& counts) {
  for (ExamineeCount& count : counts) count.correct = 0;
}

}  // namespace

void withhold_results(StudyReport& report) {
  for (CellResult& cell : report.cells) {
    cell.correct = 0;
    withhold(cell.by_examinee);
    if (cell.all) {
      cell.all->correct = 0;
      withhold(cell.all->by_examinee);
    }
    cell.response_times.reset();
  }
  report.comparisons.clear();
  report.stimuli.clear();
  report.curves.clear();
}

}  // namespace palpate::analysis
