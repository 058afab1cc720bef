#include "base/text/toml_reader.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "base/files/read_file.hpp"
#include "base/text/toml_depth.hpp"

namespace palpate::base {
namespace {

/// Letters to change, add or drop to make one word of the other (Levenshtein).
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0]++;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t change = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({change, row[j] + 1, row[j + 1] + 1});
    }
  }
  return row.back();
}

}  // namespace

std::optional<std::string> nearest_key(std::string_view typed, const std::set<std::string>& known) {
  std::optional<std::string> nearest;
  std::size_t least = 3;
  for (const std::string& key : known)
    if (const std::size_t distance = edit_distance(typed, key); distance < least) {
      nearest = key;
      least = distance;
    }
  return nearest;
}

TomlReader::TomlReader(const toml::table& table, std::string file, std::span<const Key> keys,
                       std::string path)
    : table_(table), file_(std::move(file)), path_(std::move(path)), keys_(keys.begin(), keys.end()) {}

std::string TomlReader::key_path(std::string_view key) const {
  return path_.empty() ? std::string(key) : fmt::format("{}.{}", path_, key);
}

int TomlReader::line_of(std::string_view key) const {
  const toml::node* node = table_.get(key);
  return node ? static_cast<int>(node->source().begin.line) : 0;
}

std::vector<std::string> TomlReader::keys() const {
  std::vector<std::string> names;
  for (const auto& [key, value] : table_) names.emplace_back(key.str());
  std::ranges::sort(names, {}, [this](const std::string& name) {
    const auto at = table_.get(name)->source().begin;
    return std::pair{at.line, at.column};
  });
  return names;
}

std::string TomlReader::describe(const toml::node& node) {
  if (node.is_string()) return fmt::format("the string \"{}\"", *node.value<std::string>());
  if (node.is_number()) return fmt::format("the number {}", *node.value<double>());
  if (node.is_boolean()) return *node.value<bool>() ? "true" : "false";
  if (node.is_array()) return "an array";
  if (node.is_table()) return "a table";
  return "a date or time";
}

// ---- what is refused ----

void TomlReader::refuse(std::string_view key, std::string_view what) const {
  const toml::node* node = table_.get(key);
  const auto line = (node ? node->source() : table_.source()).begin.line;
  const std::string place = line > 0 ? fmt::format("{}:{}", file_, line) : file_;
  throw std::invalid_argument(fmt::format("{}: {}: {}", place, key_path(key), what));
}

void TomlReader::refuse_value(const Key& key, std::string_view at, const toml::node& found) const {
  refuse(at, fmt::format("found {}, accepted: {}", describe(found), accepted(key)));
}

void TomlReader::refuse_later(std::span<const std::string_view> later) const {
  for (const std::string_view key : later)
    if (table_.contains(key)) refuse(key, "is not in this version; accepted: the file without it");
}

void TomlReader::refuse_later(std::string_view key, std::string_view calls_for) const {
  if (table_.contains(key))
    refuse(key, fmt::format("calls for {}, which this version does not simulate", calls_for));
}

void TomlReader::refuse_unknown() const {
  for (const std::string& key : keys())
    if (!asked_.contains(key)) refuse_unknown(key);
}

void TomlReader::refuse_unknown(std::string_view key) const {
  const auto meant = nearest_key(key, asked_);
  refuse(key,
         fmt::format("unknown key{}; accepted here: {}",
                     meant ? fmt::format(", perhaps {} is meant", *meant) : "", fmt::join(asked_, ", ")));
}

// ---- what is asked for ----

const Key& TomlReader::description(std::string_view key) const {
  for (const std::string_view name : {key, kAnyName}) {
    const auto found = std::ranges::find(keys_, name, &Key::name);
    if (found != keys_.end()) return *found;
  }
  throw std::logic_error(fmt::format("{} is read and has no description", key_path(key)));
}

bool TomlReader::has(std::string_view key) {
  if (is_required(description(key)))
    throw std::logic_error(fmt::format("{} may be absent, and is described as required", key_path(key)));
  asked_.insert(std::string(key));
  return table_.contains(key);
}

const toml::node& TomlReader::value(std::string_view key, Takes::Kind kind) {
  const Key& known = description(key);
  if (known.takes.kind != kind)
    throw std::logic_error(fmt::format("{} is read as another kind than described", key_path(key)));
  asked_.insert(std::string(key));
  if (const toml::node* found = table_.get(key)) return *found;
  if (known.fallback.empty()) refuse(key, fmt::format("is missing; accepted: {}", accepted(known)));
  if (!fallbacks_.contains(known.name))
    fallbacks_.emplace(known.name, toml::parse(fmt::format("value = {}", known.fallback)));
  return *fallbacks_.at(known.name).get("value");
}

std::string TomlReader::text(std::string_view key) {
  const toml::node& found = value(key, Takes::Kind::Text);
  if (!found.is_string()) refuse_value(description(key), key, found);
  return *found.value<std::string>();
}

std::vector<std::string> TomlReader::texts(std::string_view key) {
  std::vector<std::string> values;
  for (const toml::node& item : as_array(key, value(key, Takes::Kind::Texts))) {
    if (!item.is_string()) refuse(key, fmt::format("holds {}, accepted: strings", describe(item)));
    values.push_back(*item.value<std::string>());
  }
  return values;
}

std::string TomlReader::word(std::string_view key) {
  const toml::node& found = value(key, Takes::Kind::Word);
  if (!found.is_string()) refuse_value(description(key), key, found);
  std::string word = *found.value<std::string>();
  const Words words = description(key).takes.words();
  if (std::ranges::find(words.now, word, &Word::word) != words.now.end()) return word;
  const bool later = std::ranges::find(words.later, word) != words.later.end();
  refuse(key, fmt::format("found \"{}\"{}, accepted: {}", word, later ? ", which is not in this version" : "",
                          accepted(words)));
}

bool TomlReader::boolean(std::string_view key) {
  const toml::node& found = value(key, Takes::Kind::Boolean);
  if (!found.is_boolean()) refuse_value(description(key), key, found);
  return *found.value<bool>();
}

namespace {

bool within(const Bounds& bounds, double value) {
  if (!std::isfinite(value)) return false;
  return bounds.open ? value > bounds.least && value < bounds.most
                     : value >= bounds.least && value <= bounds.most;
}

}  // namespace

double TomlReader::number(std::string_view key) {
  const toml::node& found = value(key, Takes::Kind::Number);
  const Key& known = description(key);
  if (!found.is_number()) refuse_value(known, key, found);
  const double value = *found.value<double>();
  if (!within(known.takes.bounds, value))
    refuse(key, fmt::format("found {}, accepted: {}", value, accepted(known)));
  return value;
}

std::int64_t TomlReader::whole(std::string_view key) {
  const toml::node& found = value(key, Takes::Kind::Whole);
  const Key& known = description(key);
  if (!found.is_integer()) refuse_value(known, key, found);
  const std::int64_t value = *found.value<std::int64_t>();
  if (!within(known.takes.bounds, static_cast<double>(value)))
    refuse(key, fmt::format("found {}, accepted: {}", value, accepted(known)));
  return value;
}

Triple TomlReader::three_numbers(std::string_view key) {
  const toml::array& items = as_array(key, value(key, Takes::Kind::Numbers));
  if (items.size() != 3) refuse(key, fmt::format("has {} entries, accepted: three numbers", items.size()));
  Triple value{};
  for (std::size_t i = 0; i < 3; ++i) {
    const toml::node& item = items[i];
    if (!item.is_number()) refuse(key, fmt::format("holds {}, accepted: numbers", describe(item)));
    value[i] = *item.value<double>();
  }
  return value;
}

double TomlReader::as_quantity(const Key& key, std::string_view at, const toml::node& found) const {
  if (!found.is_string())
    refuse(at, fmt::format("found {}, accepted: a quantity with its unit, as a string", describe(found)));
  const std::string text = *found.value<std::string>();
  double value = 0.0;
  try {
    value = parse_quantity(text, key.takes.dimension);
  } catch (const std::invalid_argument& error) {
    refuse(at, error.what());
  }
  if (!within(key.takes.bounds, value))
    refuse(at, fmt::format("found \"{}\", accepted: {}", text, accepted(key)));
  return value;
}

double TomlReader::quantity(std::string_view key) {
  const toml::node& found = value(key, Takes::Kind::Quantity);
  return as_quantity(description(key), key, found);
}

Triple TomlReader::three_quantities(std::string_view key) {
  const toml::array& items = as_array(key, value(key, Takes::Kind::Quantities));
  if (items.size() != 3) refuse(key, fmt::format("has {} entries, accepted: three quantities", items.size()));
  Triple value{};
  for (std::size_t i = 0; i < 3; ++i) value[i] = as_quantity(description(key), key, items[i]);
  return value;
}

TomlReader TomlReader::table(std::string_view key, std::span<const Key> keys) {
  return table_at(key, value(key, Takes::Kind::Table), keys);
}

TomlReader TomlReader::table_at(std::string_view key, const toml::node& found,
                                std::span<const Key> keys) const {
  if (!found.is_table()) refuse_value(description(key), key, found);
  return {*found.as_table(), file_, keys, key_path(key)};
}

const toml::node& TomlReader::other(std::string_view key) {
  return value(key, Takes::Kind::Other);
}

const toml::array& TomlReader::as_array(std::string_view key, const toml::node& found) const {
  if (!found.is_array()) refuse_value(description(key), key, found);
  return *found.as_array();
}

toml::table parse_toml(std::string_view text, const std::string& file) {
  refuse_deep_toml(text, file);
  try {
    return toml::parse(text, file);
  } catch (const toml::parse_error& error) {
    throw std::invalid_argument(
        fmt::format("{}:{}: no valid TOML: {}", file, error.source().begin.line, error.description()));
  }
}

toml::table read_toml(const std::filesystem::path& file) {
  return parse_toml(read_file(file), file.string());
}

}  // namespace palpate::base
