#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/mesh/parse_mesh.hpp"
#include "tests/sim/mesh/fixtures.hpp"

// Every message names the file, the line (byte in a binary file), what was found and what is accepted.
namespace palpate::sim::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

std::string cube() {
  return to_msh2(cube_mesh(1, 1.0));  // nodes 1 to 8 on lines 6 to 13, elements on lines 17 to 22
}

std::string fixture(const char* name) {
  return read_bytes(data_file(name));
}

TEST(Refusals, MissingFile) {
  try {
    read_mesh("no/such/body.msh", 1.0);
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "no/such/body.msh: no such file, accepted: a mesh file");
  }
  EXPECT_THROW(read_mesh(data_file(""), 1.0), std::invalid_argument);  // a folder
}

TEST(Refusals, EmptyAndForeign) {
  const std::string accepted =
      "Gmsh MSH 2.2 or 4.1 (text or binary) and VTU are accepted, and with Gmsh installed MSH 1, legacy VTK, "
      "UNV, MED, Medit, Abaqus INP and Nastran, by the file name's ending";
  EXPECT_EQ(refusal(""), "body.msh: the file is empty; " + accepted);
  EXPECT_EQ(refusal(" \r\n\n"), "body.msh: the file is empty; " + accepted);
  EXPECT_EQ(refusal("solid organ\nfacet"), "body.msh:1: found 'solid organ' at the start; " + accepted);
  EXPECT_THAT(refusal(std::string("\x7f"
                                  "ELF\0\1",
                                  6)),
              HasSubstr("found '\\x7fELF\\x00\\x01'"));
  EXPECT_THAT(refusal("# vtk DataFile Version 3.0\n"), HasSubstr("VTU are accepted"));
}

TEST(Refusals, OtherMshVersions) {
  EXPECT_THAT(refusal(replaced(cube(), "2.2", "4")),
              AllOf(StartsWith("body.msh:2: found MSH version '4'"), HasSubstr("2.2 and 4.1")));
  EXPECT_THAT(refusal(replaced(cube(), "2.2 0 8", "2.2 0 4")),
              StartsWith("body.msh:2: found data size 4; 8 is accepted"));
  EXPECT_THAT(refusal(replaced(cube(), "2.2 0 8", "2.2 7 8")), StartsWith("body.msh:2: found file type 7;"));
}

TEST(Refusals, NodesInASectionThatIsNotRead) {
  std::string text = cube();
  text = replaced(text, "$Nodes", "$ParametricNodes");
  EXPECT_THAT(refusal(replaced(text, "$EndNodes", "$EndParametricNodes")),
              StartsWith("body.msh:4: found $ParametricNodes, which is not read; $Nodes is accepted"));
  text = replaced(cube(), "$Nodes", "$Vertices");
  EXPECT_THAT(refusal(replaced(text, "$EndNodes", "$EndVertices")),
              HasSubstr("and no node in a section $Nodes; not read: $Vertices"));
}

TEST(Refusals, WhatStandsBeforeTheFormatIsPassedOver) {
  const MeshFile read = parse_mesh("$Comments\nmade by hand\n$EndComments\n" + cube(), "body.msh", 1.0);
  EXPECT_EQ(read.mesh.nodes.size(), 8U);
  EXPECT_THAT(refusal("$Nodes\n0\n$EndNodes\n" + cube()),
              StartsWith("body.msh:1: found '$Nodes' where $MeshFormat is expected"));
  EXPECT_THAT(refusal("$NOD\n0\n$ENDNOD\n"), HasSubstr("found '$NOD' at the start"));  // MSH 1
}

TEST(Refusals, CommaDecimal) {
  EXPECT_EQ(refusal(replaced(cube(), "2 1 0 0", "2 1,0 0 0")),
            "body.msh:7: found '1,0' as a node's x; a finite number with a decimal point is accepted");
}

TEST(Refusals, NotFinite) {
  for (const char* bad : {"nan", "inf", "-inf", "1e999", "0x10", "--1", "1.0.0", "1e"})
    EXPECT_THAT(refusal(replaced(cube(), "2 1 0 0", fmt::format("2 {} 0 0", bad))),
                StartsWith(fmt::format("body.msh:7: found '{}' as a node's x; a finite number", bad)));
  std::string binary = fixture("two_boxes.v22.binary.msh");
  const std::size_t x = binary.find("$Nodes\n23\n") + 10 + 4;
  binary.replace(x, 8, std::string("\0\0\0\0\0\0\xf8\x7f", 8));
  EXPECT_EQ(refusal(binary),
            fmt::format("body.msh: byte {}: found nan as a node's x; a finite number is accepted", x));
}

TEST(Refusals, TooFarAway) {
  EXPECT_THAT(refusal(replaced(cube(), "2 1 0 0", "2 1e12 0 0")),
              AllOf(StartsWith("body.msh: node 2 lies"), HasSubstr("was the unit right?")));
}

TEST(Refusals, Truncated) {
  EXPECT_EQ(refusal(cube().substr(0, cube().find("$EndElements"))),
            "body.msh:23: the file ends where $EndElements is expected; it seems to be truncated");
  EXPECT_THAT(refusal(cube().substr(0, cube().find("5 4 2 0 1"))),
              StartsWith("body.msh:21: the file ends where"));
  const std::string binary = fixture("two_boxes.v41.binary.msh");
  EXPECT_THAT(refusal(binary.substr(0, binary.size() - 40)), StartsWith("body.msh: byte"));
}

TEST(Refusals, MoreClaimedThanTheFileCanHold) {
  EXPECT_EQ(refusal(replaced(cube(), "$Elements\n6", "$Elements\n1000000000")),
            "body.msh:16: 1000000000 elements are claimed, but the 122 bytes that are left in the file can "
            "hold 15 at most");
  EXPECT_THAT(refusal(replaced(cube(), "$Nodes\n8", "$Nodes\n99999999999999")),
              HasSubstr("nodes are claimed"));
  EXPECT_THAT(refusal(replaced(cube(), "$Nodes\n8", "$Nodes\n-8")), HasSubstr("-8 nodes are claimed"));
  std::string binary = fixture("two_boxes.v41.binary.msh");
  const std::size_t nodes = binary.find("$Nodes\n") + 7 + 8;
  binary.replace(nodes, 8, std::string("\xff\xff\xff\xff\xff\xff\xff\x7f", 8));
  EXPECT_THAT(refusal(binary), HasSubstr("9223372036854775807 nodes are claimed"));
}

TEST(Refusals, FewerThanClaimed) {
  EXPECT_THAT(refusal(replaced(cube(), "$Elements\n6", "$Elements\n5")),
              StartsWith("body.msh:22: found '6' where $EndElements is expected"));
}

TEST(Refusals, UnknownAndRepeatedNodes) {
  EXPECT_EQ(refusal(replaced(cube(), "1 4 2 0 1 1 ", "1 4 2 0 1 99 ")),
            "body.msh:17: found an element on node 99; $Nodes holds 8 nodes, numbered 1 to 8");
  EXPECT_THAT(refusal(replaced(cube(), "\n2 1 0 0", "\n1 1 0 0")),
              HasSubstr("$Nodes gives node 1 twice; each number is accepted once"));
  EXPECT_THAT(refusal(replaced(cube(), "\n2 1 0 0", "\n-2 1 0 0")),
              StartsWith("body.msh:7: found node number -2"));
}

TEST(Refusals, ElementsThatABodyIsNotMadeOf) {
  EXPECT_THAT(refusal(fixture("second_order.msh")),
              AllOf(HasSubstr("element type 8 (3-node line)"), HasSubstr("gmsh FILE.geo -3 -order 1")));
  EXPECT_THAT(refusal(replaced(cube(), "1 4 2", "1 11 2")), HasSubstr("(10-node tetrahedron)"));
  EXPECT_THAT(refusal(replaced(cube(), "1 4 2", "1 5 2")),
              AllOf(StartsWith("body.msh:17: found element type 5 (8-node hexahedron)"),
                    HasSubstr("fill the body with tetrahedra")));
  EXPECT_THAT(refusal(replaced(cube(), "1 4 2", "1 777 2")), HasSubstr("found element type 777;"));
}

TEST(Refusals, NoTetrahedron) {
  const std::string text = cube();
  EXPECT_THAT(refusal(text.substr(0, text.find("$Elements"))),
              HasSubstr("holds no tetrahedron; a body filled with"));
}

TEST(Refusals, OneTetrahedronTwice) {
  EXPECT_THAT(refusal(replaced(cube(), "2 4 2 0 1 1 3 7 8", "2 4 2 0 1 4 1 8 2")),
              AllOf(StartsWith("body.msh:18: the tetrahedron of nodes"), HasSubstr("is given twice")));
}

TEST(Refusals, CollapsedTetrahedron) {
  EXPECT_THAT(refusal(replaced(cube(), "1 4 2 0 1 1 2", "1 4 2 0 1 1 1")),
              HasSubstr("its nodes 1 and 1 are one or lie within"));
  EXPECT_THAT(refusal(replaced(cube(), "\n2 1 0 0", "\n2 1e-12 0 0")),
              HasSubstr("nodes 1 and 2 are one or lie within the weld tolerance"));
}

TEST(Refusals, NamesWithoutQuotes) {
  EXPECT_THAT(refusal(replaced(cube(), "$Nodes", "$PhysicalNames\n1\n2 4 touch\n$EndPhysicalNames\n$Nodes")),
              StartsWith("body.msh:6: found ' touch' as a physical group's name; a name in double quotes"));
}

TEST(Refusals, ByteOrderMark) {
  std::string binary = fixture("two_boxes.v22.binary.msh");
  binary.replace(binary.find("2.2 1 8\n") + 8, 4, "abcd");
  EXPECT_THAT(refusal(binary), HasSubstr("as the byte order mark; 1 is accepted, in either byte order"));
}

TEST(Refusals, BadUnit) {
  for (const double unit : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()})
    EXPECT_THROW(parse_mesh(cube(), "body.msh", unit), std::invalid_argument);
}

}  // namespace
}  // namespace palpate::sim::test
