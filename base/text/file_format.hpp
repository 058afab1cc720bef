#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "base/text/key.hpp"

namespace palpate::base {

/// A table as the example file has it.
struct ShownTable {
  std::string path{};                                  // "bodies.rectum"; empty: the top of the file
  std::map<std::string_view, std::string> examples{};  // where they are others than the descriptions'
};

/// The keys of one table of a file. A table may follow another of the same path: what a task brings to [task].
struct TableFormat {
  std::string path{};    // "bodies.NAME"; empty: the top of the file
  std::string called{};  // beside the path, where one path has several: "kind = \"2IFC\""
  std::string_view meaning{};
  std::vector<Key> keys{};
  std::vector<ShownTable> shown{};  // none: it is in the reference only
};

/// All that a file may hold.
struct FileFormat {
  std::string_view name{};          // "scene"
  std::string_view introduction{};  // a paragraph
  std::vector<TableFormat> tables{};
  std::vector<std::string> apart{};  // what one file cannot have together, and why: a clause each
  std::vector<std::string> later{};  // keys and words that are refused as of a later version
};

/// A file of this format with every key explained and the options commented out: what `palpate new` writes,
/// and what the reference begins with.
/// @param heading  comment lines at the top, without "# "
std::string example_file(const FileFormat& format, std::string_view heading);

/// The reference, in Markdown: the example file, then what every key takes, means, and is where it is left out.
std::string reference(const FileFormat& format, std::string_view heading);

}  // namespace palpate::base
