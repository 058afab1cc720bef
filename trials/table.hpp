#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "trials/study_file.hpp"

namespace palpate::trials {

using Value = std::variant<std::monostate, std::int64_t, double, std::string>;  // monostate: missing

struct Column {
  std::string name;         // ends in its unit, where it has one
  std::string description;  // for a codebook
};

/// A table for other tools: one row an observation, every row as long as `columns`.
struct Table {
  std::string name;
  std::vector<Column> columns{};
  std::vector<std::vector<Value>> rows{};
};

/// One row an answered question.
Table trial_table(const StudyFile& study);

/// One row an interval of an answered question, as it counted.
Table interval_table(const StudyFile& study);

/// One row a presentation that did not count: explored too little, or of a trial that was cut off.
Table exposure_table(const StudyFile& study);

/// RFC 4180: comma, LF, quotes doubled where needed; missing values are n/a. No byte-order mark.
std::string to_csv(const Table& table);

}  // namespace palpate::trials
