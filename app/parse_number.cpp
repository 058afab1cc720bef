#include "app/parse_number.hpp"

#include <fmt/core.h>

#include <charconv>
#include <cmath>
#include <optional>
#include <stdexcept>

namespace palpate::app {
namespace {

// The whole of `text` as a number: neither blanks nor anything behind it, whatever the locale.
template <typename Number>
std::optional<Number> read(std::string_view text) {
  Number value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

}  // namespace

double parse_fraction(std::string_view option, const std::string& text) {
  const std::string_view whole = text;
  const std::size_t slash = whole.find('/');
  const auto above = read<double>(whole.substr(0, slash));
  const auto below =
      slash == std::string_view::npos ? std::optional(1.0) : read<double>(whole.substr(slash + 1));
  if (above && below && std::isfinite(*above / *below)) return *above / *below;
  throw std::invalid_argument(fmt::format(
      "{} is '{}'; accepted: a fraction such as 1/2 or a decimal number such as 0.5", option, text));
}

std::vector<long> parse_counts(std::string_view option, const std::string& text, std::size_t count) {
  std::vector<long> counts;
  for (std::size_t first = 0, comma = 0; comma != std::string::npos; first = comma + 1) {
    comma = text.find(',', first);
    const auto value = read<long>(std::string_view(text).substr(first, comma - first));
    if (!value) break;
    counts.push_back(*value);
    if (comma == std::string::npos && counts.size() == count) return counts;
  }
  throw std::invalid_argument(
      fmt::format("{} is '{}'; accepted: {} whole numbers with commas between them", option, text, count));
}

}  // namespace palpate::app
