#include "trials/adaptive/level_reader.hpp"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>
#include <stdexcept>

namespace palpate::trials {
namespace {

using base::Dimension;

constexpr std::array kDimensions{Dimension::Pressure, Dimension::Length, Dimension::Time,
                                 Dimension::Force,    Dimension::Angle,  Dimension::Stiffness,
                                 Dimension::Fraction};

/// "2.0 MPa" as 2.0 and "MPa"; no name for what is no number.
struct Written {
  double number = 0.0;
  std::string unit{};
};

Written split(std::string_view text) {
  Written written;
  const auto first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return written;
  text.remove_prefix(first);
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), written.number);
  if (error != std::errc()) return written;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  const auto from = text.find_first_not_of(" \t");
  if (from == std::string_view::npos) return written;
  written.unit = text.substr(from, text.find_last_not_of(" \t") - from + 1);
  return written;
}

std::optional<LevelUnit> unit_of(const std::string& name) {
  for (const Dimension dimension : kDimensions) {
    try {
      return LevelUnit{dimension, name, base::parse_quantity("1 " + name, dimension)};
    } catch (const std::invalid_argument&) {  // of another dimension
    }
  }
  return std::nullopt;
}

std::string all_units() {
  std::string names;
  for (const Dimension dimension : kDimensions)
    names += fmt::format("{}{}", names.empty() ? "" : ", ", base::unit_names(dimension));
  return names;
}

}  // namespace

std::string level_in_words(double level, const LevelScale& scale) {
  return scale.unit ? fmt::format("{:.6g} {}", level, scale.unit->name) : fmt::format("{:.6g}", level);
}

double LevelReader::as_quantity(std::string_view key, const std::string& text) {
  const Written written = split(text);
  const auto unit = unit_of(written.unit);
  if (!unit || written.unit.empty() || !(std::abs(written.number) <= kLargestLevel))
    refuse(key, fmt::format(
                    "\"{}\" is no quantity; accepted: a number and a unit ({}), or a number without quotes",
                    text, all_units()));
  if (!scale_.known) scale_ = {.known = true, .unit = unit};
  if (!scale_.unit)
    refuse(key,
           fmt::format("found \"{}\", accepted: a number without a unit, as the levels before it", text));
  if (scale_.unit->dimension != unit->dimension)
    refuse(key, fmt::format("found \"{}\", accepted: a quantity in {}, as the levels before it", text,
                            scale_.unit->name));
  return *unit == *scale_.unit ? written.number : written.number * unit->in_si / scale_.unit->in_si;
}

double LevelReader::as_level(std::string_view key, const toml::node& found) {
  if (found.is_string()) return as_quantity(key, *found.value<std::string>());
  const auto number = found.is_number() ? found.value<double>() : std::nullopt;
  if (!number || !(std::abs(*number) <= kLargestLevel))
    refuse(key, fmt::format("found {}, accepted: {}", base::TomlReader::describe(found), kLevel.accepted));
  if (scale_.unit)
    refuse(key, fmt::format("found {}, accepted: a quantity in {}, as the levels before it",
                            base::TomlReader::describe(found), scale_.unit->name));
  scale_.known = true;
  return *number;
}

double LevelReader::level(std::string_view key) {
  return as_level(key, table_.other(key));
}

std::vector<const toml::node*> LevelReader::items(std::string_view key) {
  const toml::node& found = table_.other(key);
  if (!found.is_array()) return {&found};
  std::vector<const toml::node*> items;
  for (const toml::node& item : *found.as_array()) items.push_back(&item);
  if (items.empty()) refuse(key, "is empty; accepted: one value or more");
  return items;
}

std::vector<double> LevelReader::levels(std::string_view key) {
  std::vector<double> levels;
  for (const toml::node* item : items(key)) levels.push_back(as_level(key, *item));
  return levels;
}

std::vector<double> LevelReader::numbers(std::string_view key) {
  std::vector<double> numbers;
  for (const toml::node* item : items(key)) {
    const auto number = item->is_number() ? item->value<double>() : std::nullopt;
    if (!number || !(std::abs(*number) <= kLargestLevel))
      refuse(key, fmt::format("holds {}, accepted: numbers", base::TomlReader::describe(*item)));
    numbers.push_back(*number);
  }
  return numbers;
}

}  // namespace palpate::trials
