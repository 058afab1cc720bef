#include "analysis/description/examinee_counts.hpp"

#include <fmt/core.h>

#include <stdexcept>

namespace palpate::analysis {

Data examinee_counts_data() {
  return {.shape = Data::Shape::Columns,
          .meaning = "one examinee a row",
          .columns = {{.name = "correct", .meaning = "Correct answers of the examinee"},
                      {.name = "trials", .meaning = "of so many"}}};
}

std::vector<ExamineeCount> read_examinee_counts(const DataTable& table) {
  const std::vector<long> correct = count_column(table, "correct"), trials = count_column(table, "trials");
  std::vector<ExamineeCount> counts;
  for (std::size_t row = 0; row < correct.size(); ++row) {
    if (trials[row] < 1 || correct[row] < 0 || correct[row] > trials[row]) {
      throw std::invalid_argument(
          fmt::format("{}: {} of {} correct; accepted: 0 to all of at least one trial", place_of(table, row),
                      correct[row], trials[row]));
    }
    counts.push_back({.correct = correct[row], .trials = trials[row]});
  }
  return counts;
}

}  // namespace palpate::analysis
