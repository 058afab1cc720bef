#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/text/quantity.hpp"
#include "base/text/toml_reader.hpp"

namespace palpate::trials {

/// The unit that the levels of a table are in: the one of the first level that was read.
struct LevelUnit {
  base::Dimension dimension{};
  std::string name;    // "MPa"
  double in_si = 1.0;  // one of it

  bool operator==(const LevelUnit&) const = default;
};

/// What the levels of a table are, as the first one that was read tells.
struct LevelScale {
  bool known = false;
  std::optional<LevelUnit> unit{};  // nothing: plain numbers
};

/// "2 MPa", or the number alone.
std::string level_in_words(double level, const LevelScale& scale);

/// No level has a larger magnitude, so that what is computed of levels is finite.
inline constexpr double kLargestLevel = 1e150;

/// What a key of one level takes, and one of several.
inline constexpr base::Takes kLevel =
    base::takes_other("a number, or a quantity with its unit such as \"2.0 MPa\"");
inline constexpr base::Takes kLevels =
    base::takes_other("an array of numbers, or of quantities with their units such as \"2.0 MPa\"");
inline constexpr base::Takes kNumbers = base::takes_other("a number or an array of numbers");

/// Reads a [procedure] table whose levels are plain numbers or quantities of one kind, as the level of the
/// scene that they vary. Levels are held in the unit of the first one that is read; others are converted to
/// it.
class LevelReader {
 public:
  LevelReader(base::TomlReader& table, LevelScale& scale) : table_(table), scale_(scale) {}

  base::TomlReader& table() { return table_; }
  bool has(std::string_view key) { return table_.has(key); }

  double level(std::string_view key);
  /// One level or more, in the order of the file.
  std::vector<double> levels(std::string_view key);
  /// One number or more, or a number alone.
  std::vector<double> numbers(std::string_view key);
  /// A table within, with levels in the same unit.
  LevelReader within(base::TomlReader& table) const { return {table, scale_}; }

  std::string in_words(double level) const { return level_in_words(level, scale_); }
  const LevelScale& scale() const { return scale_; }
  [[noreturn]] void refuse(std::string_view key, std::string_view what) const { table_.refuse(key, what); }

 private:
  double as_level(std::string_view key, const toml::node& found);
  double as_quantity(std::string_view key, const std::string& text);
  std::vector<const toml::node*> items(std::string_view key);

  base::TomlReader& table_;
  LevelScale& scale_;  // of the whole table
};

}  // namespace palpate::trials
