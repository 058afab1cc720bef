#include "sim/mesh/vtu_array.hpp"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <pugixml.hpp>
#include <stdexcept>
#include <type_traits>

#include "sim/mesh/byte_stream.hpp"
#include "sim/mesh/cursor.hpp"

namespace palpate::sim {
namespace {

constexpr std::uint64_t kBestZlibRatio = 1032;  // deflate cannot pack more into a byte [RFC1951]

template <class Number>
Number number_at(const char* bytes, bool swapped) {
  std::array<char, sizeof(Number)> buffer{};
  std::memcpy(buffer.data(), bytes, sizeof(Number));
  if (swapped) std::ranges::reverse(buffer);
  Number value{};
  std::memcpy(&value, buffer.data(), sizeof(Number));
  return value;
}

std::uint64_t take_size(const VtuFile& file, ByteStream& stream) {
  const std::string bytes = stream.take(file.header_bytes);
  return file.header_bytes == 8 ? number_at<std::uint64_t>(bytes.data(), file.swapped)
                                : number_at<std::uint32_t>(bytes.data(), file.swapped);
}

std::string inflate_block(const std::string& packed, std::uint64_t size) {
  if (size > kBestZlibRatio * (packed.size() + 1))
    throw std::invalid_argument(
        fmt::format("{} bytes of zlib data claim to hold {} bytes, which they cannot", packed.size(), size));
  std::string bytes(size, '\0');
  uLongf got = size;
  const int status = ::uncompress(reinterpret_cast<Bytef*>(bytes.data()), &got,
                                  reinterpret_cast<const Bytef*>(packed.data()), packed.size());
  if (status != Z_OK || got != size)
    throw std::invalid_argument(
        fmt::format("a block of {} bytes is not zlib data of {} bytes", packed.size(), size));
  return bytes;
}

/// Number of blocks, their size, the last one's size (0: as the others), the packed size of each; then the
/// blocks.
std::string take_compressed(const VtuFile& file, ByteStream& stream) {
  const std::uint64_t blocks = take_size(file, stream), size = take_size(file, stream),
                      last = take_size(file, stream);
  if (blocks > stream.at_most() / file.header_bytes)
    throw std::invalid_argument(fmt::format("{} blocks are claimed, more than the data can hold", blocks));
  std::vector<std::uint64_t> packed_sizes(blocks);
  for (std::uint64_t& packed : packed_sizes) packed = take_size(file, stream);
  std::string bytes;
  for (std::uint64_t b = 0; b < blocks; ++b)
    bytes += inflate_block(stream.take(packed_sizes[b]), b + 1 == blocks && last != 0 ? last : size);
  return bytes;
}

std::string binary_bytes(const VtuFile& file, const pugi::xml_node& array, bool is_appended) {
  if (!is_appended) {
    ByteStream stream(array.child_value(), true);
    return file.compressed ? take_compressed(file, stream) : stream.take(take_size(file, stream));
  }
  std::int64_t offset = -1;
  if (!parse_integer(array.attribute("offset").value(), offset) || offset < 0 ||
      static_cast<std::uint64_t>(offset) >= file.appended.size())
    throw std::invalid_argument(
        fmt::format("found offset '{}'; a place within the {} bytes of appended data is accepted",
                    printable(array.attribute("offset").value()), file.appended.size()));
  ByteStream stream(file.appended.substr(offset), file.appended_is_base64);
  return file.compressed ? take_compressed(file, stream) : stream.take(take_size(file, stream));
}

template <class Stored, class Out>
std::vector<Out> convert(const VtuFile& file, const std::string& bytes) {
  if (bytes.size() % sizeof(Stored) != 0)
    throw std::invalid_argument(
        fmt::format("{} bytes are no whole number of values of {} bytes", bytes.size(), sizeof(Stored)));
  std::vector<Out> out(bytes.size() / sizeof(Stored));
  for (std::size_t i = 0; i < out.size(); ++i) {
    const auto value = number_at<Stored>(bytes.data() + i * sizeof(Stored), file.swapped);
    if constexpr (std::is_same_v<Stored, std::uint64_t>)
      if (value > static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max()))
        throw std::invalid_argument(fmt::format("found {}; numbers up to 2^63 - 1 are accepted", value));
    out[i] = static_cast<Out>(value);  // NOLINT(bugprone-signed-char-misuse): Int8 is a number, no character
  }
  return out;
}

template <class Out>
std::vector<Out> text_numbers(std::string_view text) {
  Cursor in(text, "");
  std::vector<Out> numbers;
  while (!in.at_end()) {
    const std::string_view word = in.word("a number");
    Out value{};
    bool parsed = false;
    if constexpr (std::is_same_v<Out, double>)
      parsed = parse_real(word, value);
    else
      parsed = parse_integer(word, value);
    if (!parsed)
      throw std::invalid_argument(
          fmt::format("found '{}' as value {}; a {} is accepted", printable(word), numbers.size(),
                      std::is_same_v<Out, double> ? "number with a decimal point" : "whole number"));
    numbers.push_back(value);
  }
  return numbers;
}

template <class Out>
std::vector<Out> read_numbers(const VtuFile& file, const pugi::xml_node& array) {
  const std::string format = array.attribute("format").as_string("ascii");
  if (format == "ascii") return text_numbers<Out>(array.child_value());
  if (format != "binary" && format != "appended")
    throw std::invalid_argument(
        fmt::format("found format '{}'; ascii, binary and appended are accepted", printable(format)));
  const std::string type = array.attribute("type").value();
  const std::string bytes = binary_bytes(file, array, format == "appended");
  if (type == "Int8") return convert<std::int8_t, Out>(file, bytes);
  if (type == "UInt8") return convert<std::uint8_t, Out>(file, bytes);
  if (type == "Int16") return convert<std::int16_t, Out>(file, bytes);
  if (type == "UInt16") return convert<std::uint16_t, Out>(file, bytes);
  if (type == "Int32") return convert<std::int32_t, Out>(file, bytes);
  if (type == "UInt32") return convert<std::uint32_t, Out>(file, bytes);
  if (type == "Int64") return convert<std::int64_t, Out>(file, bytes);
  if (type == "UInt64") return convert<std::uint64_t, Out>(file, bytes);
  if constexpr (std::is_same_v<Out, double>) {
    if (type == "Float32") return convert<float, Out>(file, bytes);
    if (type == "Float64") return convert<double, Out>(file, bytes);
  }
  throw std::invalid_argument(
      fmt::format("found type '{}'; {} are accepted", printable(type),
                  std::is_same_v<Out, double> ? "Float32, Float64, Int8 to UInt64" : "Int8 to UInt64"));
}

template <class Out>
std::vector<Out> read_or_refuse(const VtuFile& file, const pugi::xml_node& array) {
  try {
    return read_numbers<Out>(file, array);
  } catch (const std::invalid_argument& error) {
    refuse(file, array,
           fmt::format("array '{}': {}", printable(array.attribute("Name").value()), error.what()));
  }
}

}  // namespace

void refuse(const VtuFile& file, const pugi::xml_node& at, const std::string& sentence) {
  const auto offset =
      std::clamp<std::ptrdiff_t>(at.offset_debug(), 0, static_cast<std::ptrdiff_t>(file.text.size()));
  const auto line = 1 + std::count(file.text.begin(), file.text.begin() + offset, '\n');
  throw std::invalid_argument(fmt::format("{}:{}: {}", file.name, line, sentence));
}

std::vector<double> read_reals(const VtuFile& file, const pugi::xml_node& array) {
  std::vector<double> values = read_or_refuse<double>(file, array);
  const auto bad = std::ranges::find_if(values, [](double value) { return !std::isfinite(value); });
  if (bad != values.end())
    refuse(file, array,
           fmt::format("array '{}': found {} as value {}; a finite number is accepted",
                       printable(array.attribute("Name").value()), *bad, bad - values.begin()));
  return values;
}

std::vector<std::int64_t> read_integers(const VtuFile& file, const pugi::xml_node& array) {
  return read_or_refuse<std::int64_t>(file, array);
}

}  // namespace palpate::sim
