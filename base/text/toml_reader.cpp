#include "base/text/toml_reader.hpp"

#include <numeric>

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

void TomlReader::refuse_unknown(std::string_view key) const {
  const auto meant = nearest_key(key, asked_);
  refuse(key,
         fmt::format("unknown key{}; accepted here: {}",
                     meant ? fmt::format(", perhaps {} is meant", *meant) : "", fmt::join(asked_, ", ")));
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
