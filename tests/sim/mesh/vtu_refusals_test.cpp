#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/sim/mesh/fixtures.hpp"

namespace palpate::sim::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

std::string text() {
  return read_bytes(data_file("two_boxes.ascii.plain.uint32.little.vtu"));
}

std::string refused(const std::string& from, const std::string& to) {
  return refusal(replaced(text(), from, to), "body.vtu");
}

TEST(VtuRefusals, ForeignXml) {
  EXPECT_EQ(refusal("<svg width=\"1\"></svg>", "body.vtu"),
            "body.vtu:1: found <svg type=\"\">; <VTKFile type=\"UnstructuredGrid\"> is accepted");
  EXPECT_THAT(refused("type=\"UnstructuredGrid\"", "type=\"PolyData\""),
              HasSubstr("<VTKFile type=\"PolyData\">"));
}

TEST(VtuRefusals, Truncated) {
  const std::string whole = text();
  EXPECT_THAT(
      refusal(whole.substr(0, whole.find("</Cells>")), "body.vtu"),
      AllOf(StartsWith("body.vtu:"), HasSubstr("well-formed XML is accepted (is the file truncated?)")));
  const std::string raw = read_bytes(data_file("two_boxes.appended.raw.plain.uint64.little.vtu"));
  EXPECT_THAT(refusal(raw.substr(0, raw.size() - 60), "body.vtu"), HasSubstr("ends within <AppendedData>"));
}

TEST(VtuRefusals, Numbers) {
  EXPECT_EQ(
      refused("0 0.5 0.5 1", "0 0,5 0.5 1"),
      "body.vtu:27: array 'Points': found '0,5' as value 37; a number with a decimal point is accepted");
  EXPECT_THAT(refused("0 0.5 0.5 1", "0 nan 0.5 1"),
              HasSubstr("found nan as value 37; a finite number is accepted"));
  EXPECT_THAT(refused("0 2 12 3 1 12", "0 2 12 3 1.5 12"),
              HasSubstr("found '1.5' as value 10; a whole number is accepted"));
}

TEST(VtuRefusals, CountsThatDoNotFit) {
  EXPECT_THAT(
      refused("NumberOfPoints=\"23\"", "NumberOfPoints=\"24\""),
      HasSubstr("array 'Points' holds 69 values; 72 are accepted (three for each of NumberOfPoints)"));
  EXPECT_THAT(refused("NumberOfPoints=\"23\"", "NumberOfPoints=\"99999999999\""),
              StartsWith("body.vtu:3: found NumberOfPoints=\"99999999999\""));
  EXPECT_THAT(refused("NumberOfCells=\"58\"", "NumberOfCells=\"57\""),
              HasSubstr("array 'types' holds 58 values; 57"));
}

TEST(VtuRefusals, NodeOutOfRange) {
  EXPECT_THAT(refused("15 15 12 13 17 16", "15 15 12 99 17 16"),
              HasSubstr("names node 99; 0 to 22 are accepted"));
}

TEST(VtuRefusals, CellsThatABodyIsNotMadeOf) {
  EXPECT_THAT(refused("10 10 10 10 10 10", "10 24 10 10 10 10"),
              AllOf(HasSubstr("is of VTK type 24"), HasSubstr("Tetrahedralize")));
}

TEST(VtuRefusals, Encodings) {
  EXPECT_THAT(
      refusal(read_bytes(data_file("lz4.vtu")), "body.vtu"),
      HasSubstr("found compressor 'vtkLZ4DataCompressor'; vtkZLibDataCompressor and none are accepted"));
  EXPECT_THAT(refused("byte_order=\"LittleEndian\"", "byte_order=\"Middle\""),
              HasSubstr("found byte_order 'Middle'"));
  EXPECT_THAT(refused("header_type=\"UInt32\"", "header_type=\"UInt16\""),
              HasSubstr("found header_type 'UInt16'"));
  EXPECT_THAT(refused("Name=\"region\" format=\"ascii\"", "Name=\"region\" format=\"hex\""),
              HasSubstr("found format 'hex'"));
}

TEST(VtuRefusals, ClaimsOfPackedData) {
  const std::string inline_data = read_bytes(data_file("two_boxes.inline.plain.uint32.little.vtu"));
  // "FwAAAA" says 23 bytes: the mask of group.fixed. "////fw" says 2 GiB.
  EXPECT_THAT(refusal(replaced(inline_data, "FwAAAA", "////fw"), "body.vtu"),
              HasSubstr("array 'group.fixed': the data end too early; the file seems to be truncated"));
  const std::string packed = read_bytes(data_file("two_boxes.inline.zlib.uint32.little.vtu"));
  // "AQAAAA" says one block; "////fw" says 2^31 - 1 of them.
  EXPECT_THAT(refusal(replaced(packed, "AQAAAA", "////fw"), "body.vtu"), HasSubstr("blocks are claimed"));
}

TEST(VtuRefusals, SeveralPieces) {
  EXPECT_THAT(refused("</Piece>", "</Piece><Piece/>"), HasSubstr("found 2 pieces; one is accepted"));
}

}  // namespace
}  // namespace palpate::sim::test
