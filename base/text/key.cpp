#include "base/text/key.hpp"

#include <fmt/format.h>

namespace palpate::base {
namespace {

std::string such_as(const Key& key) {
  return key.example.empty() ? "" : fmt::format(" such as {}", key.example);
}

}  // namespace

std::string bounds_in_words(const Bounds& bounds, std::string_view unit) {
  const auto end = [&](double value) {
    return value == 0.0 || unit.empty() ? fmt::format("{}", value) : fmt::format("{:g} {}", value, unit);
  };
  const bool below = std::isfinite(bounds.least), above = std::isfinite(bounds.most);
  if (below && above)
    return fmt::format(" {} {} {} {}", bounds.open ? "greater than" : "from", end(bounds.least),
                       bounds.open ? "and less than" : "to", end(bounds.most));
  if (below) return fmt::format(" {} {}", bounds.open ? ">" : ">=", end(bounds.least));
  if (above) return fmt::format(" {} {}", bounds.open ? "<" : "<=", end(bounds.most));
  return "";
}

std::string accepted(const Words& words) {
  std::string text;
  for (const Word& known : words.now) text += fmt::format("{}{}", text.empty() ? "" : ", ", known.word);
  return text;
}

std::string accepted(const Key& key) {
  const Takes& takes = key.takes;
  switch (takes.kind) {
    case Takes::Kind::Text:
      return "a string" + such_as(key);
    case Takes::Kind::Texts:
      return "an array of strings" + such_as(key);
    case Takes::Kind::Word:
      return accepted(takes.words());
    case Takes::Kind::Boolean:
      return "true or false";
    case Takes::Kind::Number:
      return "a number" + bounds_in_words(takes.bounds, "");
    case Takes::Kind::Whole:
      return "a whole number" + bounds_in_words(takes.bounds, "");
    case Takes::Kind::Numbers:
      return "three numbers" + such_as(key);
    case Takes::Kind::Quantity:
      return fmt::format("a quantity{}{}", bounds_in_words(takes.bounds, si_unit(takes.dimension)),
                         such_as(key));
    case Takes::Kind::Quantities:
      return "three quantities" + such_as(key);
    case Takes::Kind::Table:
    case Takes::Kind::Other:
      break;
  }
  return std::string(takes.accepted);
}

}  // namespace palpate::base
