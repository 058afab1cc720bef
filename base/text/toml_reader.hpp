#pragma once

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <toml++/toml.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <optional>
#include <set>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "base/text/quantity.hpp"

namespace palpate::base {

using Triple = std::array<double, 3>;

/// Reads a TOML table strictly: every message names file, line and key, and a key that nobody asked for is
/// refused.
class TomlReader {
 public:
  TomlReader(const toml::table& table, std::string file, std::string path = "")
      : table_(table), file_(std::move(file)), path_(std::move(path)) {}

  bool has(std::string_view key) const { return table_.contains(key); }
  std::string key_path(std::string_view key) const {
    return path_.empty() ? std::string(key) : fmt::format("{}.{}", path_, key);
  }

  [[noreturn]] void refuse(std::string_view key, std::string_view what) const {
    const toml::node* node = table_.get(key);
    const auto line = (node ? node->source() : table_.source()).begin.line;
    const std::string place = line > 0 ? fmt::format("{}:{}", file_, line) : file_;
    throw std::invalid_argument(fmt::format("{}: {}: {}", place, key_path(key), what));
  }

  const toml::node* node(std::string_view key) {
    asked_.insert(std::string(key));
    return table_.get(key);
  }
  const toml::node& required(std::string_view key, std::string_view accepted) {
    const toml::node* found = node(key);
    if (!found) refuse(key, fmt::format("is missing; {}", accepted));
    return *found;
  }

  std::optional<std::string> text(std::string_view key) {
    const toml::node* found = node(key);
    if (!found) return std::nullopt;
    if (!found->is_string()) refuse(key, fmt::format("found {}, accepted: a string", describe(*found)));
    return found->value<std::string>();
  }
  std::string required_text(std::string_view key) {
    required(key, "accepted: a string");
    return *text(key);
  }

  std::optional<double> number(std::string_view key) {
    const toml::node* found = node(key);
    if (!found) return std::nullopt;
    if (!found->is_number()) refuse(key, fmt::format("found {}, accepted: a number", describe(*found)));
    return found->value<double>();
  }
  double required_number(std::string_view key) {
    required(key, "accepted: a number");
    return *number(key);
  }
  std::optional<std::int64_t> integer(std::string_view key) {
    const toml::node* found = node(key);
    if (!found) return std::nullopt;
    if (!found->is_integer())
      refuse(key, fmt::format("found {}, accepted: a whole number", describe(*found)));
    return found->value<std::int64_t>();
  }
  std::optional<bool> boolean(std::string_view key) {
    const toml::node* found = node(key);
    if (!found) return std::nullopt;
    if (!found->is_boolean()) refuse(key, fmt::format("found {}, accepted: true or false", describe(*found)));
    return found->value<bool>();
  }

  std::optional<double> quantity(std::string_view key, Dimension dimension) {
    const toml::node* found = node(key);
    if (!found) return std::nullopt;
    return as_quantity(key, *found, dimension);
  }
  double required_quantity(std::string_view key, Dimension dimension, std::string_view example) {
    required(key, fmt::format("accepted: a quantity such as {}", example));
    return *quantity(key, dimension);
  }

  std::optional<std::vector<std::string>> texts(std::string_view key) {
    const toml::node* found = node(key);
    if (!found) return std::nullopt;
    std::vector<std::string> values;
    for (const toml::node& item : as_array(key, *found, "an array of strings")) {
      if (!item.is_string()) refuse(key, fmt::format("holds {}, accepted: strings", describe(item)));
      values.push_back(*item.value<std::string>());
    }
    return values;
  }

  /// Three lengths or angles with their units.
  std::optional<Triple> vector_quantity(std::string_view key, Dimension dimension) {
    const toml::node* found = node(key);
    if (!found) return std::nullopt;
    return as_vector_quantity(key, *found, dimension);
  }
  Triple as_vector_quantity(std::string_view key, const toml::node& found, Dimension dimension) const {
    const toml::array& items = as_array(key, found, "three quantities");
    if (items.size() != 3)
      refuse(key, fmt::format("has {} entries, accepted: three quantities", items.size()));
    Triple value{};
    for (std::size_t i = 0; i < 3; ++i) value[i] = as_quantity(key, items[i], dimension);
    return value;
  }
  std::optional<Triple> vector_number(std::string_view key) {
    const toml::node* found = node(key);
    if (!found) return std::nullopt;
    const toml::array& items = as_array(key, *found, "three numbers");
    if (items.size() != 3) refuse(key, fmt::format("has {} entries, accepted: three numbers", items.size()));
    Triple value{};
    for (std::size_t i = 0; i < 3; ++i) {
      const toml::node& item = items[i];
      if (!item.is_number()) refuse(key, fmt::format("holds {}, accepted: numbers", describe(item)));
      value[i] = *item.value<double>();
    }
    return value;
  }

  std::optional<TomlReader> table(std::string_view key) {
    const toml::node* found = node(key);
    if (!found) return std::nullopt;
    if (!found->is_table()) refuse(key, fmt::format("found {}, accepted: a table", describe(*found)));
    return TomlReader(*found->as_table(), file_, key_path(key));
  }
  std::vector<std::string> keys() const {
    std::vector<std::string> names;
    for (const auto& [key, value] : table_) names.emplace_back(key.str());
    std::ranges::sort(names, {}, [this](const std::string& name) {  // the order of the file
      const auto at = table_.get(name)->source().begin;
      return std::pair{at.line, at.column};
    });
    return names;
  }

  /// Refuses a key of a later version as such. To be called before anything is required that such a key would
  /// stand for.
  void refuse_later(std::span<const std::string_view> later) const {
    for (const std::string_view key : later)
      if (has(key)) refuse(key, "is not in this version; accepted: the file without it");
  }

  /// Refuses the first key that was never asked for.
  void refuse_unknown() const {
    for (const std::string& key : keys())
      if (!asked_.contains(key)) refuse_unknown(key);
  }

  [[noreturn]] void refuse_unknown(std::string_view key) const;

  const std::string& file() const { return file_; }

  static std::string describe(const toml::node& node) {
    if (node.is_string()) return fmt::format("the string \"{}\"", *node.value<std::string>());
    if (node.is_number()) return fmt::format("the number {}", *node.value<double>());
    if (node.is_boolean()) return *node.value<bool>() ? "true" : "false";
    if (node.is_array()) return "an array";
    if (node.is_table()) return "a table";
    return "a date or time";
  }
  const toml::array& as_array(std::string_view key, const toml::node& found,
                              std::string_view accepted) const {
    if (!found.is_array()) refuse(key, fmt::format("found {}, accepted: {}", describe(found), accepted));
    return *found.as_array();
  }

 private:
  double as_quantity(std::string_view key, const toml::node& found, Dimension dimension) const {
    if (!found.is_string())
      refuse(key, fmt::format("found {}, accepted: a quantity with its unit, as a string", describe(found)));
    try {
      return parse_quantity(*found.value<std::string>(), dimension);
    } catch (const std::invalid_argument& error) {
      refuse(key, error.what());
    }
  }

  const toml::table& table_;
  std::string file_;
  std::string path_;
  std::set<std::string> asked_;
};

/// The known key that a mistyped one is nearest to: at most 2 letters wrong, missing or too many; else
/// nothing.
std::optional<std::string> nearest_key(std::string_view typed, const std::set<std::string>& known);

/// Parses TOML; a syntax error names file and line, and so does a key of more parts or a value of more
/// brackets than any of ours has (toml_depth.hpp). Throws std::invalid_argument.
toml::table parse_toml(std::string_view text, const std::string& file);
toml::table read_toml(const std::filesystem::path& file);

}  // namespace palpate::base
