#pragma once

#include <optional>
#include <string>
#include <vector>

#include "trials/protocol/protocol.hpp"

namespace palpate::trials {

/// What the cells of a column hold. Utc: a point in time, ISO 8601.
enum class Kind { Text, Whole, Real, Utc };
std::string_view to_string(Kind kind);

/// A value that a cell may have, and what it means.
struct Level {
  std::string value;
  std::string meaning;
};

/// One column as a reader needs it described: every exported file and codebook is made from this.
struct Column {
  std::string name{};   // snake_case; ends in its unit, where it has one
  std::string title{};  // a few words
  std::string description{};
  std::string unit{};  // SI symbol: s, ms, m, N, Hz; empty: none
  Kind kind = Kind::Text;
  std::optional<double> least{}, most{};
  std::vector<Level> levels{};  // empty: any value of its kind
  std::string pattern{};        // of the whole cell, ECMAScript; empty: any
  bool may_be_missing = false;  // written n/a then
};

/// A column of whole numbers, none below `least`.
Column whole_column(std::string name, std::string title, std::string description, double least);

// The columns of the tables, for a study of this protocol. A name that stands in several of them is
// described in the same words.
std::vector<Column> trial_columns(const Protocol& protocol);
std::vector<Column> interval_columns(const Protocol& protocol);
std::vector<Column> exposure_columns(const Protocol& protocol);
std::vector<Column> event_columns();

/// The pattern of a column's cells: its own, or that of its levels (without the lengths of its numbers);
/// empty where there is none.
std::string pattern_of(const Column& column);

}  // namespace palpate::trials
