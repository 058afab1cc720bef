#include "base/text/quantity.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <charconv>
#include <cmath>
#include <numbers>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace palpate::base {
namespace {

struct Unit {
  std::string_view name;
  double in_si;
};

constexpr std::array kLength{Unit{"m", 1.0}, Unit{"cm", 1e-2}, Unit{"mm", 1e-3}, Unit{"um", 1e-6}};
constexpr std::array kPressure{Unit{"Pa", 1.0}, Unit{"kPa", 1e3}, Unit{"MPa", 1e6}, Unit{"GPa", 1e9}};
constexpr std::array kTime{Unit{"s", 1.0}, Unit{"ms", 1e-3}, Unit{"us", 1e-6}, Unit{"min", 60.0}};
constexpr std::array kForce{Unit{"N", 1.0}, Unit{"mN", 1e-3}, Unit{"kN", 1e3}};
constexpr std::array kAngle{Unit{"rad", 1.0}, Unit{"deg", std::numbers::pi / 180.0}};
constexpr std::array kStiffness{Unit{"N/m", 1.0}, Unit{"N/mm", 1e3}};
constexpr std::array kFraction{Unit{"", 1.0}, Unit{"%", 1e-2}};

std::span<const Unit> units_of(Dimension dimension) {
  switch (dimension) {
    case Dimension::Length:
      return kLength;
    case Dimension::Pressure:
      return kPressure;
    case Dimension::Time:
      return kTime;
    case Dimension::Force:
      return kForce;
    case Dimension::Angle:
      return kAngle;
    case Dimension::Stiffness:
      return kStiffness;
    case Dimension::Fraction:
      return kFraction;
  }
  return {};
}

std::string accepted(std::span<const Unit> units) {
  std::vector<std::string_view> names;
  for (const Unit& unit : units)
    if (!unit.name.empty()) names.push_back(unit.name);
  return fmt::format("{}", fmt::join(names, ", "));
}

std::string_view trim(std::string_view text) {
  const auto first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

}  // namespace

double parse_quantity(std::string_view text, Dimension dimension) {
  const auto units = units_of(dimension);
  const std::string_view trimmed = trim(text);
  double value = 0.0;
  const auto [end, error] = std::from_chars(trimmed.data(), trimmed.data() + trimmed.size(), value);
  if (error != std::errc() || !std::isfinite(value))
    throw std::invalid_argument(
        fmt::format("\"{}\" is no quantity; a number and a unit are accepted ({})", text, accepted(units)));
  const std::string_view name = trim(trimmed.substr(end - trimmed.data()));
  for (const Unit& unit : units)
    if (unit.name == name) return value * unit.in_si;
  if (name.empty())
    throw std::invalid_argument(fmt::format("\"{}\" has no unit; accepted units: {}", text, accepted(units)));
  throw std::invalid_argument(
      fmt::format("\"{}\" has the unit \"{}\"; accepted units: {}", text, name, accepted(units)));
}

std::string unit_names(Dimension dimension) {
  return accepted(units_of(dimension));
}

std::string_view in_words(Dimension dimension) {
  constexpr std::array<std::string_view, 7> kWords{"length", "pressure",  "time",    "force",
                                                   "angle",  "stiffness", "fraction"};
  return kWords.at(static_cast<std::size_t>(dimension));
}

std::string_view si_unit(Dimension dimension) {
  return units_of(dimension).front().name;
}

double metres_per_unit(std::string_view unit) {
  for (const Unit& known : kLength)
    if (known.name == unit) return known.in_si;
  throw std::invalid_argument(
      fmt::format("\"{}\" is no unit of length; accepted: {}", unit, accepted(kLength)));
}

}  // namespace palpate::base
