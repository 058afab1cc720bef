#include "analysis/procedures/read_number.hpp"

#include <charconv>
#include <cmath>
#include <system_error>

namespace palpate::analysis {
namespace {

template <typename Number>
std::optional<Number> read(std::string_view text) {
  if (text.size() > 1 && text.front() == '+' && text[1] != '-') text.remove_prefix(1);
  Number value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

}  // namespace

std::optional<long> read_count(std::string_view text) {
  return read<long>(text);
}

std::optional<double> read_finite(std::string_view text) {
  const auto value = read<double>(text);
  return value && std::isfinite(*value) ? value : std::nullopt;
}

std::optional<double> read_fraction(std::string_view text) {
  const std::size_t slash = text.find('/');
  if (slash == std::string_view::npos) return read_finite(text);
  const auto above = read_finite(text.substr(0, slash));
  const auto below = read_finite(text.substr(slash + 1));
  if (!above || !below || *below == 0) return std::nullopt;
  return *above / *below;
}

}  // namespace palpate::analysis
