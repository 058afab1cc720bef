// docs/procedures.md names every adaptive procedure and each of its keys, with what stands where a key is
// left out.
#include <gtest/gtest.h>

#include "base/files/read_file.hpp"
#include "tests/support/places.hpp"
#include "trials/adaptive/adaptive.hpp"

namespace palpate::trials::test {
namespace {

/// The part of the document under a heading, up to the next one.
std::string section(const std::string& document, std::string_view name) {
  const auto from = document.find("\n## " + std::string(name) + "\n");
  if (from == std::string::npos) return "";
  return document.substr(from, document.find("\n## ", from + 1) - from);
}

}  // namespace

TEST(ProceduresDocument, HasEveryKeyOfEveryProcedure) {
  const std::string document = base::read_file(palpate::test::source_folder() + "/docs/procedures.md");
  for (const AdaptiveProcedure* procedure : adaptive_procedures()) {
    const std::string part = section(document, procedure->name);
    EXPECT_NE(part, "") << procedure->name << " has no section";
    for (const base::Key& key : procedure->keys) {
      const auto row = part.find("\n| `" + std::string(key.name) + "` | ");
      ASSERT_NE(row, std::string::npos) << procedure->name << "." << key.name;
      const std::string line = part.substr(row + 1, part.find('\n', row + 1) - row - 1);
      if (!key.fallback.empty()) {
        EXPECT_NE(line.find("| `" + std::string(key.fallback) + "` |"), std::string::npos) << line;
      }
    }
  }
}

}  // namespace palpate::trials::test
