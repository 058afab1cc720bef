#include "analysis/words/words.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace palpate::analysis {

std::string p_in_words(double p) {
  if (std::isnan(p)) return "p not available";
  if (p < 0.0001) return "p < 0.0001";
  if (p >= 0.9995) return p < 1 ? "p > 0.999" : "p = 1";
  return p < 0.001 ? fmt::format("p = {:.4f}", p) : fmt::format("p = {:.3f}", p);
}

std::string bare_p(double p) {
  const std::string words = p_in_words(p);
  return words.substr(words.starts_with("p = ") ? 4 : 2);
}

std::string to_the_second(std::string_view utc) {
  constexpr std::size_t kDate = 10, kTime = 8;
  if (utc.size() < kDate + 1 + kTime || utc[kDate] != 'T') return std::string(utc);
  return fmt::format("{} {}", utc.substr(0, kDate), utc.substr(kDate + 1, kTime));
}

std::string out_of(long correct, long trials) {
  return fmt::format("{} of {}", correct, trials);
}

std::string percent(double proportion) {
  return std::isnan(proportion) ? "n/a" : fmt::format("{:.1f} %", 100 * proportion);
}

std::string number(double value) {
  if (std::isnan(value)) return "n/a";
  if (std::isinf(value)) return value > 0 ? "infinite" : "minus infinite";
  return fmt::format("{:.4g}", value == 0 ? 0.0 : value);  // no "-0"
}

std::string decimals(double value, int count) {
  if (!std::isfinite(value)) return number(value);
  const std::string text = fmt::format("{:.{}f}", value, count);
  const bool zero = text.find_first_not_of("-0.") == std::string::npos;
  return zero && text.starts_with('-') ? text.substr(1) : text;
}

std::string percent_range(const Interval& interval) {
  if (std::isnan(interval.lower) || std::isnan(interval.upper)) return "none";
  return percent(interval.lower) + " to " + percent(interval.upper);
}

std::string range(const Interval& interval) {
  return range(interval, [](double value) { return number(value); });
}

std::string range(const Interval& interval, const std::function<std::string(double)>& written) {
  const bool below = std::isinf(interval.lower), above = std::isinf(interval.upper);
  if (std::isnan(interval.lower) || std::isnan(interval.upper)) return "none";
  if (below && above) return "any value";
  if (below) return "up to " + written(interval.upper);
  if (above) return written(interval.lower) + " and more";
  return written(interval.lower) + " to " + written(interval.upper);
}

std::string short_percent(double proportion) {
  std::string text = fmt::format("{:.4g}", 100 * proportion);
  for (int digits = 5; text == "100" && proportion != 1.0 && digits <= 17; ++digits)
    text = fmt::format("{:.{}g}", 100 * proportion, digits);
  return text + " %";
}

std::string listed(const std::vector<std::string>& items) {
  std::string text;
  for (std::size_t i = 0; i < items.size(); ++i) {
    if (i > 0) text += i + 1 == items.size() ? " and " : ", ";
    text += items[i];
  }
  return text;
}

std::string chance_in_words(double chance) {
  const double choices = std::round(1 / chance);
  if (choices <= 100 && std::abs(chance * choices - 1) < 1e-12) return fmt::format("1/{:.0f}", choices);
  return number(chance);
}

std::size_t columns(std::string_view text) {
  return std::ranges::count_if(text, [](char c) {
    return (static_cast<unsigned char>(c) & 0xC0) != 0x80;  // a UTF-8 continuation byte takes no column
  });
}

std::string wrapped(std::string_view text, std::string_view first, std::string_view next, std::size_t width) {
  std::vector<std::string> words;
  std::istringstream source{std::string(text)};
  for (std::string word; source >> word;) {
    if (word.starts_with('%') && !words.empty())  // a number and its sign stay together
      words.back() += " " + word;
    else
      words.push_back(word);
  }
  std::string out, row(first);
  bool empty = true;
  for (const std::string& word : words) {
    if (!empty && columns(row) + 1 + columns(word) > width) {
      out += row + "\n";
      row = next;
      empty = true;
    }
    row += (empty ? "" : " ") + word;
    empty = false;
  }
  return out + row + "\n";
}

}  // namespace palpate::analysis
