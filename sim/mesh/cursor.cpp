#include "sim/mesh/cursor.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstring>
#include <limits>
#include <stdexcept>

namespace palpate::sim {
namespace {

bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f';
}
bool is_white(char c) {
  return is_blank(c) || c == '\n';
}

template <class Number>
bool parse_whole(std::string_view text, Number& value) {
  if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size();
}

}  // namespace

std::string printable(std::string_view bytes) {
  std::string out;
  for (const char c : bytes.substr(0, 40)) {
    const auto byte = static_cast<unsigned char>(c);
    out += byte >= 0x20 && byte < 0x7f ? std::string(1, c) : fmt::format("\\x{:02x}", byte);
  }
  return bytes.size() > 40 ? out + "..." : out;
}

bool parse_real(std::string_view text, double& value) {
  return parse_whole(text, value);
}
bool parse_integer(std::string_view text, std::int64_t& value) {
  return parse_whole(text, value);
}

void Cursor::set_binary(bool swapped) {
  binary_ = true;
  swapped_ = swapped;
}

void Cursor::skip_white() {
  while (offset_ < bytes_.size() && is_white(bytes_[offset_])) ++offset_;
}

bool Cursor::at_end() {
  skip_white();
  return offset_ == bytes_.size();
}

std::string_view Cursor::rest() {
  skip_white();
  return bytes_.substr(offset_);
}

std::string_view Cursor::word(const char* accepted) {
  if (at_end())
    refuse(offset_, fmt::format("the file ends where {} is expected; it seems to be truncated", accepted));
  last_ = offset_;
  while (offset_ < bytes_.size() && !is_white(bytes_[offset_])) ++offset_;
  return bytes_.substr(last_, offset_ - last_);
}

std::string_view Cursor::rest_of_line() {
  last_ = offset_;
  const std::size_t end = std::min(bytes_.find('\n', offset_), bytes_.size());
  offset_ = std::min(end + 1, bytes_.size());
  std::string_view line = bytes_.substr(last_, end - last_);
  if (line.ends_with('\r')) line.remove_suffix(1);
  return line;
}

void Cursor::end_of_line() {
  while (offset_ < bytes_.size() && is_blank(bytes_[offset_])) ++offset_;
  if (offset_ < bytes_.size() && bytes_[offset_] != '\n')
    refuse(offset_, fmt::format("found '{}' where the end of the line is expected",
                                printable(bytes_.substr(offset_, 12))));
  offset_ = std::min(offset_ + 1, bytes_.size());
}

void Cursor::expect(std::string_view exact_word) {
  const std::string accepted(exact_word);
  const std::string_view found = word(accepted.c_str());
  if (found != exact_word)
    refuse_last(fmt::format("found '{}' where {} is expected", printable(found), accepted));
}

void Cursor::skip_past(std::string_view text) {
  const std::size_t found = bytes_.find(text, offset_);
  if (found == std::string_view::npos)
    refuse(bytes_.size(), fmt::format("the file ends before {}; it seems to be truncated", text));
  offset_ = found + text.size();
}

std::int64_t Cursor::text_integer(const char* what) {
  const std::string_view text = word(what);
  std::int64_t value = 0;
  if (!parse_integer(text, value))
    refuse_last(fmt::format("found '{}' as {}; a whole number is accepted", printable(text), what));
  return value;
}

template <class Number>
Number Cursor::raw(const char* what) {
  if (remaining() < sizeof(Number))
    refuse(bytes_.size(), fmt::format("the file ends where {} is expected; it seems to be truncated", what));
  last_ = offset_;
  std::array<char, sizeof(Number)> buffer{};
  std::memcpy(buffer.data(), bytes_.data() + offset_, sizeof(Number));
  if (swapped_) std::ranges::reverse(buffer);
  offset_ += sizeof(Number);
  Number value{};
  std::memcpy(&value, buffer.data(), sizeof(Number));
  return value;
}

std::int64_t Cursor::integer(const char* what) {
  return binary_ ? raw<std::int32_t>(what) : text_integer(what);
}

std::int64_t Cursor::size(const char* what) {
  const std::int64_t value = binary_ ? raw<std::int64_t>(what) : text_integer(what);
  if (value < 0)
    refuse_last(fmt::format("found {} as {}; a number from 0 to 2^63 - 1 is accepted", value, what));
  return value;
}

double Cursor::real(const char* what) {
  double value = 0.0;
  if (binary_) {
    value = raw<double>(what);
    if (!std::isfinite(value))
      refuse_last(fmt::format("found {} as {}; a finite number is accepted", value, what));
    return value;
  }
  const std::string_view text = word(what);
  if (!parse_real(text, value) || !std::isfinite(value))
    refuse_last(fmt::format("found '{}' as {}; a finite number with a decimal point is accepted",
                            printable(text), what));
  return value;
}

std::size_t Cursor::claim(std::int64_t count, std::int64_t numbers, std::int64_t binary_bytes,
                          const char* what) {
  const std::int64_t each = binary_ ? binary_bytes : 2 * numbers;  // a digit and a blank at least
  const auto left = static_cast<std::int64_t>(remaining()) + (binary_ ? 0 : 1);
  if (count < 0 || count > std::numeric_limits<std::int32_t>::max() || count > left / each)
    refuse_last(
        fmt::format("{} {} are claimed, but the {} bytes that are left in the file can hold {} at most",
                    count, what, remaining(), left / each));
  return count;
}

void Cursor::refuse(std::size_t at, const std::string& sentence) const {
  if (binary_) throw std::invalid_argument(fmt::format("{}: byte {}: {}", file_, at, sentence));
  const auto end = bytes_.begin() + static_cast<std::ptrdiff_t>(std::min(at, bytes_.size()));
  const auto line = 1 + std::count(bytes_.begin(), end, '\n');
  throw std::invalid_argument(fmt::format("{}:{}: {}", file_, line, sentence));
}

}  // namespace palpate::sim
