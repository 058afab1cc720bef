#include "trials/adaptive/load_adaptive.hpp"

#include <algorithm>
#include <array>

#include "base/files/read_file.hpp"

namespace palpate::trials {
namespace {

base::Words kind_words() {
  base::Words words;
  for (const AdaptiveProcedure* procedure : adaptive_procedures())
    words.now.push_back({procedure->name, procedure->meaning});
  return words;
}

constexpr std::array kFileKeys{
    base::Key{.name = "procedure", .takes = base::takes_table("a table [procedure]")},
};
constexpr std::array kKindKeys{
    base::Key{.name = "kind", .takes = base::takes_word(kind_words), .meaning = "How levels are chosen."},
    base::Key{.name = "level",
              .takes = base::kText,
              .absent = "a number alone",
              .meaning = "The quantity of the scene that is varied."},
};

}  // namespace

LoadedProcedure parse_adaptive(std::string_view text, const std::string& file) {
  const toml::table content = base::parse_toml(text, file);
  base::TomlReader root(content, file, kFileKeys);
  base::TomlReader table = root.table("procedure", kKindKeys);
  const std::string kind = table.word("kind");
  LoadedProcedure loaded;
  loaded.procedure = *std::ranges::find(adaptive_procedures(), kind, &AdaptiveProcedure::name);
  if (table.has("level")) loaded.level = table.text("level");
  table.also(loaded.procedure->keys);
  LevelReader reader(table, loaded.scale);
  loaded.design = loaded.procedure->read(reader);
  table.refuse_unknown();
  return loaded;
}

LoadedProcedure load_adaptive(const std::filesystem::path& file) {
  return parse_adaptive(base::read_file(file, "a file with a [procedure] table"), file.string());
}

}  // namespace palpate::trials
