#include <fmt/format.h>

#include "sim/mesh/msh_content.hpp"
#include "sim/mesh/parse_mesh.hpp"

namespace palpate::sim {
namespace {

constexpr const char* kHowToSave =
    "Gmsh MSH 2.2 and 4.1 are accepted: gmsh FILE -save -format msh41 -o OUT.msh writes one";

/// What stands before $MeshFormat is passed over as it is behind it, but for what the format decides about.
void skip_to_format(Cursor& in) {
  for (std::string_view rest = in.rest(); !rest.starts_with("$MeshFormat"); rest = in.rest()) {
    const std::string section(in.word("$MeshFormat"));
    if (!section.starts_with('$') || section == "$Nodes" || section == "$Elements" || section == "$Entities")
      in.refuse_last(fmt::format("found '{}' where $MeshFormat is expected", printable(section)));
    in.skip_past("$End" + section.substr(1));
  }
}

/// Reads $MeshFormat and returns the version's first digit.
int read_format(Cursor& in) {
  in.expect("$MeshFormat");
  const std::string version(in.word("the format's version"));
  if (version != "2.2" && version != "4.1")
    in.refuse_last(fmt::format("found MSH version '{}'; {}", printable(version), kHowToSave));
  const std::int64_t is_binary = in.text_integer("the file type (0 text, 1 binary)");
  if (is_binary != 0 && is_binary != 1)
    in.refuse_last(fmt::format("found file type {}; 0 (text) and 1 (binary) are accepted", is_binary));
  const std::int64_t data_size = in.text_integer("the data size");
  if (data_size != 8) in.refuse_last(fmt::format("found data size {}; 8 is accepted", data_size));
  in.end_of_line();
  if (is_binary == 1) {
    in.set_binary(false);
    const std::int64_t one = in.integer("the byte order mark");
    if (one != 1 && one != 0x01000000)
      in.refuse_last(
          fmt::format("found {} as the byte order mark; 1 is accepted, in either byte order", one));
    in.set_binary(one != 1);
  }
  in.expect("$EndMeshFormat");
  in.end_of_line();
  return version == "2.2" ? 2 : 4;
}

void read_names(Cursor& in, MshContent& content) {
  const std::int64_t count = in.text_integer("the number of physical names");
  for (std::int64_t i = 0; i < count; ++i) {
    const std::int64_t dimension = in.text_integer("a physical group's dimension");
    if (dimension < 0 || dimension > 3)
      in.refuse_last(fmt::format("found dimension {} of a physical group; 0 to 3 are accepted", dimension));
    const std::int64_t tag = in.text_integer("a physical group's tag");
    const std::string_view line = in.rest_of_line();
    const std::size_t first = line.find('"'), last = line.rfind('"');
    if (first == last || last - first < 2)
      in.refuse_last(fmt::format("found '{}' as a physical group's name; a name in double quotes is accepted",
                                 printable(line)));
    const std::string name(line.substr(first + 1, last - first - 1));
    content.names[{static_cast<int>(dimension), tag}] = name;
  }
}

void read_section(Cursor& in, const std::string& name, int version, MshContent& content) {
  if (name == "PhysicalNames") {
    read_names(in, content);
  } else if (name == "Entities" && version == 4) {
    read_msh4_entities(in, content);
  } else if (name == "Nodes") {
    version == 2 ? read_msh2_nodes(in, content) : read_msh4_nodes(in, content);
  } else if (name == "Elements") {
    version == 2 ? read_msh2_elements(in, content) : read_msh4_elements(in, content);
  } else if (name == "ParametricNodes") {
    in.refuse_last(
        "found $ParametricNodes, which is not read; $Nodes is accepted (Mesh.SaveParametric = 0 in Gmsh, and "
        "saved again)");
  } else if (name == "PartitionedEntities") {
    in.refuse_last(
        "the mesh is partitioned; one piece is accepted (gmsh FILE -save -format msh22 -o OUT.msh joins it)");
  } else {
    in.skip_past("$End" + name);  // comments, fields, periodicity: nothing that a body needs
    content.passed_over.push_back("$" + name);
    return;
  }
  in.expect("$End" + name);
}

}  // namespace

TetMesh parse_msh(std::string_view bytes, const std::string& name) {
  Cursor in(bytes, name);
  skip_to_format(in);
  const int version = read_format(in);
  MshContent content;
  while (!in.at_end()) {
    const std::string_view word = in.word("a section");
    if (!word.starts_with('$') || word.size() < 2 || word.starts_with("$End"))
      in.refuse_last(
          fmt::format("found '{}'; a section such as $Nodes or $Elements is accepted", printable(word)));
    const std::string section(word.substr(1));
    in.end_of_line();
    read_section(in, section, version, content);
  }
  return assemble(in, content);
}

}  // namespace palpate::sim
