#include "analysis/description/read_number.hpp"

#include <charconv>
#include <cmath>
#include <system_error>

namespace palpate::analysis {
namespace {

std::string_view without_plus(std::string_view text) {
  if (text.size() > 1 && text.front() == '+' && text[1] != '-') text.remove_prefix(1);
  return text;
}

template <typename Number>
std::optional<Number> read(std::string_view text) {
  text = without_plus(text);
  Number value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

bool has_use(double value) {
  const double magnitude = std::abs(value);
  return value == 0 || (magnitude >= kLeastMagnitude && magnitude <= kMostMagnitude);
}

}  // namespace

std::optional<long> read_count(std::string_view text) {
  const auto value = read<long>(text);
  return value && *value >= 0 && *value <= kMostCount ? value : std::nullopt;
}

std::optional<long> read_seed(std::string_view text) {
  const auto value = read<long>(text);
  return value && *value >= 0 ? value : std::nullopt;
}

std::optional<double> read_number(std::string_view text) {
  const auto value = read_finite(text);
  return value && has_use(*value) ? value : std::nullopt;
}

std::optional<double> read_finite(std::string_view text) {
  const auto value = read<double>(text);
  return value && std::isfinite(*value) ? value : std::nullopt;
}

std::optional<double> read_fraction(std::string_view text) {
  const std::size_t slash = text.find('/');
  if (slash == std::string_view::npos) return read_number(text);
  const auto above = read_finite(text.substr(0, slash));
  const auto below = read_finite(text.substr(slash + 1));
  if (!above || !below || *below == 0) return std::nullopt;
  const double value = *above / *below;
  return has_use(value) ? std::optional(value) : std::nullopt;
}

bool is_numeral(std::string_view text) {
  text = without_plus(text);
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error != std::errc::invalid_argument && end == text.data() + text.size() && !std::isnan(value);
}

}  // namespace palpate::analysis
