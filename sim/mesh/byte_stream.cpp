#include "sim/mesh/byte_stream.hpp"

#include <fmt/format.h>

#include <stdexcept>
#include <utility>

#include "sim/mesh/cursor.hpp"

namespace palpate::sim {
namespace {

constexpr std::string_view kAlphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

[[noreturn]] void refuse_end() {
  throw std::invalid_argument("the data end too early; the file seems to be truncated");
}

}  // namespace

std::size_t ByteStream::at_most() const {
  return base64_ ? decoded_.size() + encoded_.size() / 4 * 3 : encoded_.size();
}

void ByteStream::decode_four() {
  unsigned int bits = 0;
  int read = 0, padding = 0;
  while (read < 4) {
    const std::size_t next = encoded_.find_first_not_of(" \t\r\n");
    if (next == std::string_view::npos) refuse_end();
    const char c = encoded_[next];
    encoded_.remove_prefix(next + 1);
    const std::size_t value = kAlphabet.find(c);
    const bool is_padding = c == '=' && read >= 2;
    if ((value == std::string_view::npos && !is_padding) || (padding > 0 && !is_padding))
      throw std::invalid_argument(fmt::format("found '{}' in base64 data", printable({&c, 1})));
    padding += is_padding;
    bits = bits << 6U | (is_padding ? 0U : static_cast<unsigned int>(value));
    ++read;
  }
  for (int i = 0; i < 3 - padding; ++i)
    decoded_ +=
        static_cast<char>(static_cast<unsigned char>(bits >> (16 - 8 * static_cast<unsigned int>(i))));
}

std::string ByteStream::take(std::size_t count) {
  if (count > at_most()) refuse_end();
  if (!base64_) {
    std::string taken(encoded_.substr(0, count));
    encoded_.remove_prefix(count);
    return taken;
  }
  decoded_.reserve(count + 3);
  while (decoded_.size() < count) decode_four();
  std::string rest = decoded_.substr(count);
  decoded_.resize(count);
  return std::exchange(decoded_, std::move(rest));
}

}  // namespace palpate::sim
