#pragma once

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <toml++/toml.h>

#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/text/key.hpp"

namespace palpate::base {

using Triple = std::array<double, 3>;

/// Reads a TOML table strictly, by the descriptions of its keys: every message names file, line and key, and a
/// key that nobody asked for is refused. What a key takes, where its value must be and what stands where it is
/// left out come from its description; to ask for a key that has none, or for a value of another kind, is a
/// mistake of the program (std::logic_error). What a file has wrong is thrown as std::invalid_argument.
class TomlReader {
 public:
  TomlReader(const toml::table& table, std::string file, std::span<const Key> keys, std::string path = "");

  /// Further keys, which another key calls for: those of a task.
  void also(std::span<const Key> keys) { keys_.insert(keys_.end(), keys.begin(), keys.end()); }

  /// Whether the file has the key; for one whose absence means something.
  bool has(std::string_view key);

  // The value in the file, else what the description says stands there. Missing: refused.
  std::string text(std::string_view key);
  std::vector<std::string> texts(std::string_view key);
  std::string word(std::string_view key);
  bool boolean(std::string_view key);
  double number(std::string_view key);
  std::int64_t whole(std::string_view key);
  Triple three_numbers(std::string_view key);
  double quantity(std::string_view key);  // [SI]
  Triple three_quantities(std::string_view key);
  TomlReader table(std::string_view key, std::span<const Key> keys);
  const toml::node& other(std::string_view key);
  /// A value that may be a table, as one.
  TomlReader table_at(std::string_view key, const toml::node& found, std::span<const Key> keys) const;

  /// The value that one of the words stands for, which are those of the description.
  template <class Enum, std::size_t count>
  Enum word(std::string_view key, const EnumWords<Enum, count>& words) {
    return value_of(words, word(key)).value();
  }

  /// In the order of the file.
  std::vector<std::string> keys() const;
  std::string key_path(std::string_view key) const;
  int line_of(std::string_view key) const;  // 0: the file does not have it
  const std::string& file() const { return file_; }

  [[noreturn]] void refuse(std::string_view key, std::string_view what) const;

  /// Refuses a key of a later version as such. To be called before anything is required that such a key would
  /// stand for.
  void refuse_later(std::span<const std::string_view> later) const;
  /// Refuses one such key, with what it would call for.
  void refuse_later(std::string_view key, std::string_view calls_for) const;

  /// Refuses the first key that was never asked for.
  void refuse_unknown() const;
  [[noreturn]] void refuse_unknown(std::string_view key) const;

  static std::string describe(const toml::node& node);
  const toml::array& as_array(std::string_view key, const toml::node& found) const;

 private:
  const Key& description(std::string_view key) const;
  const toml::node& value(std::string_view key, Takes::Kind kind);
  [[noreturn]] void refuse_value(const Key& key, std::string_view at, const toml::node& found) const;
  double as_quantity(const Key& key, std::string_view at, const toml::node& found) const;

  const toml::table& table_;
  std::string file_;
  std::string path_;
  std::vector<Key> keys_;
  std::set<std::string> asked_{};
  std::map<std::string_view, toml::table> fallbacks_{};  // read as if they stood in the file
};

/// The known key that a mistyped one is nearest to: at most 2 letters wrong, missing or too many; else
/// nothing.
std::optional<std::string> nearest_key(std::string_view typed, const std::set<std::string>& known);

/// Parses TOML; a syntax error names file and line, and so does a key of more parts or a value of more
/// brackets than any of ours has (toml_depth.hpp). Throws std::invalid_argument.
toml::table parse_toml(std::string_view text, const std::string& file);
toml::table read_toml(const std::filesystem::path& file);

}  // namespace palpate::base
