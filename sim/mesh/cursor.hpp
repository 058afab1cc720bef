#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace palpate::sim {

/// Bytes of a foreign file made fit for a message: unprintable ones escaped, cut after 40.
std::string printable(std::string_view bytes);

/// The whole of `text` as a number with a decimal point, whatever the locale. False when it is none.
bool parse_real(std::string_view text, double& value);
bool parse_integer(std::string_view text, std::int64_t& value);

/// Reads a file held in memory from front to back: words separated by white space, and in a binary file
/// numbers of fixed width. Every method throws std::invalid_argument that names the file, the line (byte in a
/// binary file), what was found and what is accepted.
class Cursor {
 public:
  Cursor(std::string_view bytes, std::string file) : bytes_(bytes), file_(std::move(file)) {}

  /// From here on numbers are binary; `swapped` when the file's byte order is not this machine's.
  void set_binary(bool swapped);
  bool binary() const { return binary_; }
  bool swapped() const { return swapped_; }

  bool at_end();  // but for white space
  std::size_t here() const { return offset_; }
  std::size_t remaining() const { return bytes_.size() - offset_; }
  std::string_view rest();  // from the next byte that is not white on

  std::string_view word(const char* accepted);
  std::string_view rest_of_line();  // without its end, LF or CRLF
  void end_of_line();               // nothing but blanks may stand before it
  void expect(std::string_view exact_word);
  void skip_past(std::string_view text);

  std::int64_t text_integer(const char* what);
  std::int64_t integer(const char* what);  // binary: 4 bytes
  std::int64_t size(const char* what);     // binary: 8 bytes, unsigned; never negative
  double real(const char* what);           // binary: 8 bytes

  /// A count that the file claims, refused before memory is taken for it when the bytes that are left cannot
  /// hold that many records of `numbers` numbers, `binary_bytes` long in a binary file.
  std::size_t claim(std::int64_t count, std::int64_t numbers, std::int64_t binary_bytes, const char* what);

  [[noreturn]] void refuse(std::size_t at, const std::string& sentence) const;
  [[noreturn]] void refuse_last(const std::string& sentence) const { refuse(last_, sentence); }

 private:
  void skip_white();
  template <class Number>
  Number raw(const char* what);

  std::string_view bytes_;
  std::string file_;
  std::size_t offset_ = 0;
  std::size_t last_ = 0;  // start of what was read last
  bool binary_ = false;
  bool swapped_ = false;
};

}  // namespace palpate::sim
