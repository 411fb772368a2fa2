// Spreadsheets that other programs wrote (fixtures/make_tables.py), and what becomes of broken ones.
#include <fstream>

#include "engine/core/temporary_folder.h"
#include "engine/drawing/drawing_test_support.h"
#include "engine/drawing/read_drawing.h"
#include "engine/drawing/read_formats.h"
#include "engine/drawing/xlsx_test_support.h"

namespace dda {
namespace {

using std::string_literals::operator""s;

TEST(ReadXlsx, TablesOnSeveralSheets) {
  const LineDrawing drawing = read_xlsx(text_of_fixture("tables.xlsx"), "plan.xlsx", 1e-3);
  expect_triangle_with_joint(drawing);
  EXPECT_EQ(drawing.passed_over.at("sheet without a header"), 1);
  EXPECT_EQ(drawing.lines[1].origin, "plan.xlsx, sheet \"Lines & joints\" row 3");
  EXPECT_EQ(drawing.points[0].origin, "plan.xlsx, sheet \"Points\" row 6");
}

TEST(ReadXlsx, IsADrawingByItsExtension) {
  EXPECT_TRUE(is_drawing("PLAN.XLSX"));
  expect_triangle_with_joint(read_drawing(fixture("tables.xlsx"), "plan.xlsx", 1e-3));
}

// Which a table of formats with one empty entry took for a drawing, and crashed.
TEST(ReadDrawing, AFileWithoutAnExtensionIsNone) {
  for (const char* name : {"plan", "", ".", "plan.", "plan.xls"}) {
    EXPECT_FALSE(is_drawing(name)) << name;
    expect_refused([&] { read_drawing(name, name); },
                   "expected a .dxf, .csv, .xlsx, .geojson, .dc, .geo, .blck or .blk file");
  }
}

TEST(ReadDrawing, TablesAsUnicodeTextAreRefused) {
  const TemporaryFolder folder;
  std::ofstream(folder / "plan.csv", std::ios::binary) << "\xFE\xFF\0l\0a"s;
  expect_refused([&] { read_drawing(folder / "plan.csv", "plan.csv"); },
                 "plan.csv is text in UTF-16, expected text in UTF-8");
}

TEST(ReadXlsx, OneTableWithSharedTexts) {
  expect_triangle_with_joint(read_xlsx(text_of_fixture("one_sheet.xlsx"), "plan.xlsx", 1e-3));
}

const std::string header =
    R"(<x:row><x:c t="str"><x:v>layer</x:v></x:c><x:c t="str"><x:v>x</x:v></x:c><x:c t="str"><x:v>y</x:v></x:c></x:row>)";

TEST(ReadXlsx, PrefixesAndCellsWithoutReferences) {
  const LineDrawing drawing = read_xlsx(
      workbook(
          header +
          R"(<x:row><x:c t="str"><x:v>rock</x:v></x:c><x:c><x:v>1.5</x:v></x:c><x:c><x:v>-2E-1</x:v></x:c></x:row>)"),
      "a.xlsx", 0);
  ASSERT_EQ(drawing.points.size(), 1U);
  EXPECT_EQ(drawing.points[0].at, Vec2(1.5, -0.2));
}

TEST(ReadXlsx, WhatIsWrongIsSaidInOneSentence) {
  const auto row = [](const std::string& last) {
    return header + R"(<x:row r="7"><x:c t="str"><x:v>rock</x:v></x:c><x:c><x:v>1</x:v></x:c>)" + last + "</x:row>";
  };
  const std::string tables = text_of_fixture("tables.xlsx");
  std::string broken = tables;
  broken[broken.find("xl/worksheets/sheet2.xml") + 200] ^= 1;
  ZipFile empty;
  empty.add("readme", "nothing");
  const std::vector<std::pair<std::string, std::string>> all{
      {"", "a.xlsx is no archive, or cut off, expected an .xlsx file"},
      {"layer,x,y\nrock,0,0 and so on\n", "a.xlsx is no archive, or cut off"},
      {tables.substr(0, tables.size() / 2), "a.xlsx is no archive, or cut off"},
      {broken, "a.xlsx is an archive whose xl/worksheets/sheet2.xml is broken"},
      {empty.bytes(), "a.xlsx is an archive without a workbook"},
      {workbook(""), "a.xlsx is without a table, expected a sheet with a header"},
      {workbook("<x:row>"), "a.xlsx is a spreadsheet whose xl/s.xml is no XML"},
      {workbook(row("")), "a.xlsx, sheet \"S\" row 7, column y is \"\", expected a finite number"},
      {workbook(row(R"(<x:c t="e"><x:v>#REF!</x:v></x:c>)")), "column y is \"#REF!\", expected a finite number"},
      {workbook(row(R"(<x:c t="s"><x:v>3</x:v></x:c>)")), "a.xlsx is with a cell of text \"3\", which it lacks"},
  };
  for (const auto& each : all) expect_refused([&] { read_xlsx(each.first, "a.xlsx", 0); }, each.second);
}

}  // namespace
}  // namespace dda
