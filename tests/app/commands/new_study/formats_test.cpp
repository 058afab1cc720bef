// What the reference and a new study show is what the readers take.
#include "app/commands/new_study/formats.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <toml++/toml.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "sim/compile/compile.hpp"
#include "sim/scene/scene.hpp"
#include "tests/support/places.hpp"
#include "tests/support/temporary_folder.hpp"
#include "trials/observer/observer.hpp"
#include "trials/protocol/protocol.hpp"

namespace palpate::app {
namespace {

namespace fs = std::filesystem;

/// A folder as `palpate new` makes it.
class NewStudy : public testing::Test {
 protected:
  NewStudy() {
    fs::create_directory(folder_ / "meshes");
    for (const char* mesh : {"prostate.msh", "rectum.msh"})
      fs::copy_file(fs::path(test::source_folder()) / "data/meshes" / mesh, folder_ / "meshes" / mesh);
    write("scene.toml", new_scene());
    write("protocol.toml", protocol());
  }

  static std::string protocol() {
    return new_protocol("mine", *trials::tasks().front(), *trials::procedures().front());
  }
  fs::path write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name) << text;
    return folder_ / name;
  }
  /// Throws what the reader refuses.
  void read(std::string_view format, const std::string& text) const {
    if (format == "scene") sim::load_scene(write("scene.toml", text));
    if (format == "protocol") trials::load_protocol(write("protocol.toml", text));
    if (format == "observer") trials::load_observer(write("observer.toml", text));
  }
  /// The same with the meshes.
  void use(std::string_view format, const std::string& text) const {
    read(format, text);
    sim::ComplianceCache cache({});
    if (format == "scene") sim::compile(sim::load_scene(folder_ / "scene.toml"), cache);
  }

  static std::string text_of(std::string_view format) {
    if (format == "scene") return new_scene();
    if (format == "protocol") return protocol();
    return base::example_file(format_of("observer"), "");
  }

 private:
  test::TemporaryFolder folder_{};
};

std::vector<std::string> parts_of(const std::string& path) {
  std::vector<std::string> parts;
  std::istringstream in(path);
  for (std::string part; std::getline(in, part, '.');) parts.push_back(part);
  return parts;
}

/// Where the example file shows a table; for one that it does not show, a place that it could stand.
std::string path_of(const base::TableFormat& table) {
  if (!table.shown.empty()) return table.shown.front().path;
  std::string path = table.path;
  for (const auto& [name, shown] : {std::pair{"bodies.NAME", "bodies.prostate"}, {"GROUP", "nodule"}})
    if (const auto at = path.find(name); at != std::string::npos)
      path.replace(at, std::string(name).size(), shown);
  return path;
}

toml::table& table_at(toml::table& root, const std::string& path) {
  toml::table* table = &root;
  for (const std::string& part : parts_of(path)) {
    if (!(*table)[part].is_table()) table->insert_or_assign(part, toml::table{});
    table = (*table)[part].as_table();
  }
  return *table;
}

void put(toml::table& into, std::string_view lines) {
  const toml::table parsed = toml::parse(lines);
  for (const auto& [key, node] : parsed)
    node.visit([&into, &key = key](const auto& value) { into.insert_or_assign(key, value); });
}

std::string example_of(const base::TableFormat& table, const base::Key& key) {
  std::string value(key.example);
  if (!table.shown.empty() && table.shown.front().examples.contains(key.name))
    value = table.shown.front().examples.at(key.name);
  return key.name == base::kAnyName ? value : std::string(key.name) + " = " + value;
}

class EveryFile : public NewStudy, public testing::WithParamInterface<const char*> {};

TEST_P(EveryFile, AsItIsShownWholeIsAccepted) {
  EXPECT_NO_THROW(use(GetParam(), text_of(GetParam())));
}

// Each fragment alone put into the whole file, with the lines that go with it.
TEST_P(EveryFile, EveryExampleOfTheReferenceIsAccepted) {
  int tried = 0;
  for (const base::TableFormat& table : format_of(GetParam()).tables)
    for (const base::Key& key : table.keys) {
      if (key.takes.kind == base::Takes::Kind::Table) continue;
      toml::table root = toml::parse(text_of(GetParam()));
      toml::table& into = table_at(root, path_of(table));
      if (table.shown.empty())
        for (const base::Key& other : table.keys)
          if (base::is_required(other)) put(into, example_of(table, other));
      into.erase(key.instead_of);
      put(into, example_of(table, key));
      put(into, key.along);
      std::ostringstream text;
      text << root;
      EXPECT_NO_THROW(read(GetParam(), text.str())) << table.path << ": " << example_of(table, key);
      ++tried;
    }
  EXPECT_GT(tried, 15);
}

/// A line of the file taken in, or replaced where it is there.
void take_in(std::string& text, const std::string& line) {
  const std::string key = "\n" + line.substr(0, line.find('=') + 1);
  auto at = text.find("\n#" + key.substr(1));
  if (at == std::string::npos) at = text.find(key);
  ASSERT_NE(at, std::string::npos) << line;
  text.replace(at + 1, text.find('\n', at + 1) - at - 1, line);
}

// As somebody does it who reads the file: the # taken away.
TEST_P(EveryFile, EveryOptionIsAcceptedOnceItsHashIsGone) {
  int tried = 0;
  const std::string whole = text_of(GetParam());
  for (const base::TableFormat& table : format_of(GetParam()).tables)
    for (const base::Key& key : table.keys) {
      const std::string line = std::string(key.name) + " = " + std::string(key.example);
      if (table.shown.empty() || whole.find("\n#" + line) == std::string::npos) continue;
      if (key.name == "group") continue;  // the example's mesh has none that could be held
      std::string text = whole;
      take_in(text, line);
      std::istringstream along{std::string(key.along)};
      for (std::string beside; std::getline(along, beside);) take_in(text, beside);
      if (!key.instead_of.empty()) {
        const auto at = text.find("\n" + std::string(key.instead_of) + " = ");
        ASSERT_NE(at, std::string::npos);
        text.insert(at + 1, "#");
      }
      EXPECT_NO_THROW(use(GetParam(), text)) << line;
      ++tried;
    }
  EXPECT_GE(tried, GetParam() == std::string("observer") ? 0 : 4);
}

// No key may be missing from what a beginner is shown, but those of tables that the example has no use for.
TEST_P(EveryFile, EveryKeyIsExplainedInIt) {
  const std::string whole = text_of(GetParam());
  for (const base::TableFormat& table : format_of(GetParam()).tables)
    for (const base::Key& key : table.keys) {
      if (key.takes.kind == base::Takes::Kind::Table) continue;
      EXPECT_FALSE(key.meaning.empty()) << table.path << "." << key.name;
      EXPECT_FALSE(example_of(table, key).ends_with("= ")) << table.path << "." << key.name;
      if (!table.shown.empty() && key.name != base::kAnyName)
        EXPECT_THAT(whole, testing::ContainsRegex("\n#?" + std::string(key.name) + " = "));
    }
}

TEST_P(EveryFile, EveryWordOfAListOfWordsIsExplained) {
  for (const base::TableFormat& table : format_of(GetParam()).tables)
    for (const base::Key& key : table.keys) {
      if (key.takes.kind != base::Takes::Kind::Word || key.name == "length_unit") continue;
      for (const base::Word& known : key.takes.words().now)
        EXPECT_FALSE(known.meaning.empty()) << table.path << "." << key.name << " = " << known.word;
    }
}

INSTANTIATE_TEST_SUITE_P(Files, EveryFile, testing::Values("scene", "protocol", "observer"),
                         [](const auto& file) { return std::string(file.param); });

}  // namespace
}  // namespace palpate::app
