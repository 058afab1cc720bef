#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace pugi {
class xml_node;
}

namespace palpate::sim {

/// A VTK XML file in memory and how it encodes its arrays.
struct VtuFile {
  std::string name;
  std::string_view text;
  std::string_view appended;  // what follows the underscore in <AppendedData>
  bool appended_is_base64 = false;
  bool swapped = false;          // its byte order is not this machine's
  bool compressed = false;       // by zlib, in blocks
  std::size_t header_bytes = 4;  // width of the sizes before the data: 4 or 8
};

/// Throws std::invalid_argument with file, line of the element and the sentence.
[[noreturn]] void refuse(const VtuFile& file, const pugi::xml_node& at, const std::string& sentence);

/// The numbers of a <DataArray>, be it text, inline base64 or appended. No memory is taken for sizes that the
/// file's bytes cannot hold. Reals are finite. Throws std::invalid_argument.
std::vector<double> read_reals(const VtuFile& file, const pugi::xml_node& array);
std::vector<std::int64_t> read_integers(const VtuFile& file, const pugi::xml_node& array);

}  // namespace palpate::sim
