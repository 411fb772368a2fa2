// Files with bytes changed, lost and doubled are read, or refused in one sentence.
#include "engine/core/fuzz_support.h"
#include "engine/cutting/cut_rock.h"
#include "engine/drawing/drawing_test_support.h"
#include "engine/drawing/read_formats.h"
#include "engine/drawing/run_data.h"
#include "engine/drawing/write_blocks.h"
#include "engine/drawing/xlsx_test_support.h"

namespace dda {
namespace {

using Reader = LineDrawing (*)(std::string_view, const std::string&, double);

struct Tally {
  int taken = 0;
  int refused = 0;
};

// `count`, or as many as DDA_FUZZ_INPUTS says. Any other exception ends the test, and so does an input that takes a
// minute.
Tally read_mutations(const std::string& seed, std::size_t from, Reader reader, std::uint64_t count) {
  Mutator mutator(7);
  Tally tally;
  for (std::uint64_t i = 0; i < number_from_environment("DDA_FUZZ_INPUTS", count); ++i) {
    const InputWatch watch(i);
    const std::string text = mutator.text(seed, from);
    try {
      const RockPlan plan = plan_of(reader(text, "plan", 0), shapes_options());
      if (i % 4 == 0 && (!plan.boundary.empty() || !plan.blocks.empty())) cut_rock(plan);
      ++tally.taken;
    } catch (const InputError& error) {
      EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
      ++tally.refused;
    }
  }
  return tally;
}

// Both happen often, or the changes would try nothing.
void expect_both(const Tally& tally) {
  EXPECT_GT(tally.taken, 50);
  EXPECT_GT(tally.refused, 50);
}

TEST(Mutations, OfDxf) {
  for (const char* name : {"shapes.dxf", "tunnel.dxf"}) {
    const std::string seed = text_of_fixture(name);
    expect_both(read_mutations(seed, seed.find("BLOCKS"), read_dxf, 2000));
  }
}

TEST(Mutations, OfSplinesThroughFitPoints) {
  std::string seed = "0\nSECTION\n2\nENTITIES\n";
  for (const char* ends :
       {"10\n0\n20\n0\n11\n4\n21\n0\n", "10\n4\n20\n0\n11\n0\n21\n4\n", "10\n0\n20\n4\n11\n0\n21\n0\n"})
    seed += std::string("0\nLINE\n8\numriss\n") + ends;
  const std::size_t from = seed.size();
  seed +=
      "0\nSPLINE\n8\nrock\n70\n0\n71\n3\n74\n4\n12\n1\n22\n1\n11\n0\n21\n1\n11\n1\n21\n1."
      "5\n11\n2\n21\n1\n11\n4\n21\n1\n";
  seed += "0\nSPLINE\n8\nrock\n70\n1\n11\n1\n21\n1\n11\n2\n21\n1\n11\n1\n21\n2\n0\nENDSEC\n0\nEOF\n";
  expect_both(read_mutations(seed, from, read_dxf, 4000));
}

TEST(Mutations, OfCsv) {
  expect_both(
      read_mutations("layer,x1,y1,x2,y2,x,y\numriss,0,0,4,0,,\numriss,4,0,0,4,,\numriss,0,4,0,0,,\nrock,0,1,4,1,,\n"
                     "fix point,,,,,1,1\n",
                     0, read_csv_drawing, 4000));
}

// First bytes of the archive, where checksums catch those of its files; then the XML of a sheet.
TEST(Mutations, OfXlsx) {
  const Tally tally = read_mutations(text_of_fixture("tables.xlsx"), 0, read_xlsx, 4000);
  EXPECT_GT(tally.refused, 50);
  const auto read_sheet = [](std::string_view rows, const std::string& name, double metres) {
    return read_xlsx(workbook(std::string(rows)), name, metres);
  };
  const auto row = [](const std::string& layer, const std::string& numbers) {
    std::string cells = "<row r=\"1\"><c r=\"A1\" t=\"str\"><v>" + layer + "</v></c>";
    for (const char number : numbers) cells += std::string("<c><v>") + number + "</v></c>";
    return cells + "</row>";
  };
  const std::string header =
      "<row><c t=\"inlineStr\"><is><t>layer</t></is></c><c t=\"str\"><v>x1</v></c><c t=\"str\"><v>y1</v></c>"
      "<c t=\"str\"><v>x2</v></c><c t=\"str\"><v>y2</v></c></row>";
  expect_both(read_mutations(
      header + row("umriss", "0040") + row("umriss", "4004") + row("umriss", "0400") + row("rock", "0141"), 0,
      read_sheet, 4000));
}

TEST(Mutations, OfDc) {
  expect_both(
      read_mutations("0.001\n6 0\n1\n0\n2\n1\n1\n0\n0 0 4 0 1\n4 0 4 4 1\n4 4 0 4 1\n0 4 0 0 1\n-0.5 2 4.5 2 2\n"
                     "2 -0.5 2 4.5 3\n0 1 4 1 2\n1 0.5 3 0.5\n1 3 1 3\n3.5 1\n0.5 0.5\n",
                     0, read_dc, 10000));
}

TEST(Mutations, OfDcAsAppendixAHasIt) {
  expect_both(read_mutations(
      "0.001\n6 0\n0 0 1 1 1 1 0 1\n0 0 4 0 1\n4 0 4 4 1\n4 4 0 4 1\n0 4 0 0 1\n-0.5 2 4.5 2 1\n2 -0.5 2 4.5 1\n"
      "1 1 1\n1\n3 1\n0.5 1\n3 3\n3 1\n1 1\n2\n4 0 4 4\n0 4 0 0\n0\n",
      0, read_dc, 10000));
}

TEST(Mutations, OfBlck) {
  expect_both(read_mutations(
      "2 0 16\n1 1 1\n1 1 4\n2 9 12\n1 0 0\n1 4 0\n2 4 1\n1 0 1\n1 0 0\n0 4 0\n0 8 2\n0 0 0\n2 0 1\n2 2 1\n"
      "1 2 3\n1 0 3\n2 0 1\n0 4 0\n0 4 8\n0 0 0\n0.5 0 1\n1 3 2\n1 1 2\n",
      0, read_blck, 10000));
}

// Numbers of both layouts.
TEST(Mutations, OfRunData) {
  const std::string materials = "2600 25506 2e10 0.25\n-1 -2 0.5 0 0 0\n0.1 0.2 0.3\n35 0 0\n20 1e5 0\n";
  Tally tally;
  for (const std::string& seed :
       {"1\n20\n1\n2\n0.005\n0.01\n" + materials, "0\n20\n1\n2\n0.005\n0\n0\n0 2\n0 0 0\n1 0 -5\n" + materials}) {
    Mutator mutator(7);
    for (std::uint64_t i = 0; i < number_from_environment("DDA_FUZZ_INPUTS", 5000); ++i) {
      const InputWatch watch(i);
      const std::string text = mutator.text(seed, 0);
      try {
        read_run_data(text, "run.df", 2);
        ++tally.taken;
      } catch (const InputError& error) {
        EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
        ++tally.refused;
      }
    }
  }
  expect_both(tally);
}

TEST(Mutations, OfGeoJson) {
  expect_both(read_mutations(
      R"({"type": "FeatureCollection", "features": [{"type": "Feature", "properties": {"layer": "umriss"},
 "geometry": {"type": "Polygon", "coordinates": [[[0, 0], [4, 0], [0, 4], [0, 0]]]}},
 {"type": "Feature", "properties": {"layer": "rock"}, "geometry": {"type": "LineString", "coordinates": [[0, 1], [4, 1]]}}]})",
      0, read_geojson, 4000));
}

// Drawings of blocks, with holes and extended data.
TEST(Mutations, OfExportedBlocks) {
  const BlockDrawing blocks{
      {{"a wall", "a wall 1", {{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{{1, 1}, {1, 2}, {2, 1}}}}, "stone"},
       {"a wall", "a wall 2", {{{1, 1}, {2, 1}, {1, 2}}, {}}, "stone"}},
      {{"bed", {1, 1}, {2, 1}}, {"default", {1, 1}, {1, 2}}}};
  const std::string dxf = block_file("blocks.dxf", blocks);
  expect_both(read_mutations(dxf, dxf.find("ENTITIES"), read_dxf, 4000));
  expect_both(read_mutations(block_file("blocks.geojson", blocks), 0, read_geojson, 4000));
}

}  // namespace
}  // namespace dda
