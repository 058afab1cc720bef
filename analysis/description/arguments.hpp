#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/description/data_table.hpp"
#include "analysis/numerics/result.hpp"

namespace palpate::analysis {

/// One value that a statistic takes besides its data: `--trials 60` on the command line, "trials": 60 in a
/// batch line.
struct Input {
  enum class Kind {
    Count,     // 60
    Seed,      // a count without an upper bound
    Number,    // -0.25
    Fraction,  // 1/2 or 0.5
    Choice,    // one of `choices`
    Counts,    // 794,86,150,570 or [794, 86, 150, 570]
    Numbers,   // 0.25,1.5 or [0.25, 1.5]
    PValues,   // the same, and as small as they come
    Text,      // anything
    Switch     // --name, or true
  };
  std::string name{};
  Kind kind = Kind::Number;
  std::string meaning{};               // "Correct answers"
  std::optional<std::string> usual{};  // taken where none is given
  bool optional = false;               // may be left out although nothing is usual
  std::vector<std::string> choices{};  // of a Choice
};

struct InputColumn {
  std::string name{};
  std::string meaning{};
  bool optional = false;
};

/// The data that a statistic takes: a CSV file on the command line, "data": {"level": [..], ..} or
/// "file": "answers.csv" in a batch line.
struct Data {
  enum class Shape {
    None,
    Columns,  // those of `columns`, by name; a file of one column needs no header
    Matrix    // every column is one of the things compared, every row an examinee; two columns at least
  };
  Shape shape = Shape::None;
  std::string meaning{};  // of a row
  std::vector<InputColumn> columns{};
  bool optional = false;  // may be left out: the inputs say it all
};

/// What a statistic was asked, checked against its description. The functions below may only be asked for
/// what that description names.
struct Arguments {
  nlohmann::json values{};  // by name; what was left out and has no usual value is absent
  DataTable table{};

  bool given(std::string_view name) const;
  long count(std::string_view name) const;     // Count or Seed
  double number(std::string_view name) const;  // Number or Fraction
  std::string text(std::string_view name) const;
  std::vector<long> counts(std::string_view name) const;
  std::vector<double> numbers(std::string_view name) const;  // Numbers or PValues
  bool is_on(std::string_view name) const;                   // Switch
  Side side() const;                                         // "side"
  double level() const;                                      // "level"
};

struct Statistic;

/// Checks `given` (an object: numbers may be texts, as from a command line) and `table` against the
/// description. Throws std::invalid_argument that says what was found and what is accepted: unknown keys,
/// values missing or of the wrong kind, data where none belong or none where they are needed.
Arguments read_arguments(const Statistic& statistic, const nlohmann::json& given, DataTable table);

}  // namespace palpate::analysis
