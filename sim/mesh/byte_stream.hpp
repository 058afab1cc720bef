#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace palpate::sim {

/// Bytes taken from the front of raw or base64 text. Base64 may be padded between any two pieces, since VTK
/// encodes the sizes before the data on their own when it compresses, and together with the data when not.
class ByteStream {
 public:
  ByteStream(std::string_view encoded, bool base64) : encoded_(encoded), base64_(base64) {}

  /// The most bytes that can still be taken.
  std::size_t at_most() const;

  /// Takes `count` bytes. Throws std::invalid_argument when there are fewer, or a character is not base64.
  std::string take(std::size_t count);

 private:
  void decode_four();

  std::string_view encoded_;
  bool base64_;
  std::string decoded_;  // base64 that was decoded but not taken yet
};

}  // namespace palpate::sim
