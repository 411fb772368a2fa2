// Blocks for other programs, and what comes of them when they are read again.
#include <nlohmann/json.hpp>

#include "engine/cutting/cut_rock.h"
#include "engine/drawing/drawing_test_support.h"
#include "engine/drawing/dxf_names.h"
#include "engine/drawing/read_formats.h"
#include "engine/drawing/write_blocks.h"

namespace dda {
namespace {

const std::string gallery = "tunnel \xC3\xB6st";
const std::string long_name = "a joint of a name so long that DXF cuts it off";

// A block beside one whose hole another fills.
const BlockDrawing three_blocks{
    {{"rock", "rock 1", {{{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {}}, "granite"},
     {gallery, gallery + " 1", {{{1, 0}, {4, 0}, {4, 3}, {1, 1}}, {{{2, 0.5}, {3, 1}, {3, 0.5}}}}, "clay"},
     {gallery, gallery + " 2", {{{2, 0.5}, {3, 0.5}, {3, 1}}, {}}, "clay"}},
    {{"default", {1, 0}, {1, 1}}, {long_name, {2, 0.5}, {3, 0.5}}}};

CutRock read_again(const std::string& file, const std::string& text) {
  const bool is_dxf = file.ends_with(".dxf");
  return cut_rock(plan_of(is_dxf ? read_dxf(text, file, 0) : read_geojson(text, file, 0), {}));
}

void expect_three_blocks(const CutRock& rock) {
  ASSERT_EQ(rock.blocks.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    const ExportedBlock& expected = three_blocks.blocks[i];
    EXPECT_EQ(rock.blocks[i].shape.outer, expected.shape.outer);
    EXPECT_EQ(rock.blocks[i].shape.holes, expected.shape.holes);
    EXPECT_EQ(rock.blocks[i].group, expected.group);
    EXPECT_EQ(rock.blocks[i].material, expected.material);
  }
  ASSERT_EQ(rock.joints.size(), 2U);
  EXPECT_EQ(rock.joints[0].joint, "");
  EXPECT_EQ(rock.joints[1].joint, long_name);
  EXPECT_TRUE(rock.cleaned.empty());
}

TEST(WriteBlocks, DxfAndGeoJsonGiveTheSameBlocksAgain) {
  for (const std::string file : {"blocks.dxf", "blocks.geojson"}) {
    SCOPED_TRACE(file);
    expect_three_blocks(read_again(file, block_file(file, three_blocks)));
  }
}

// Rules of RFC 7946: rings closed and of four positions or more, outer ones counter-clockwise, holes clockwise.
TEST(WriteBlocks, GeoJsonFollowsTheRightHandRule) {
  const auto document = nlohmann::json::parse(block_file("blocks.geojson", three_blocks));
  EXPECT_EQ(document["type"], "FeatureCollection");
  int rings = 0;
  for (const auto& feature : document["features"]) {
    EXPECT_EQ(feature["type"], "Feature");
    if (feature["geometry"]["type"] != "Polygon") continue;
    bool outer = true;
    for (const auto& positions : feature["geometry"]["coordinates"]) {
      Ring ring;
      for (const auto& position : positions) ring.push_back({position[0].get<double>(), position[1].get<double>()});
      EXPECT_GE(ring.size(), 4U);
      EXPECT_EQ(ring.front(), ring.back());
      EXPECT_EQ(signed_area(ring) > 0, outer);
      outer = false;
      ++rings;
    }
  }
  EXPECT_EQ(rings, 4);
}

std::string without(const std::string& text, const std::string& first, const std::string& last) {
  std::string kept = text;
  for (std::size_t at = kept.find(first); at != std::string::npos; at = kept.find(first, at))
    kept.erase(at, kept.find(last, at + first.size()) + last.size() - at);
  return kept;
}

// Some programs drop extended data: the names of layers remain.
TEST(WriteBlocks, DxfWithoutExtendedDataKeepsWhatLayersCanSay) {
  std::string text = block_file("blocks.dxf", three_blocks);
  for (const std::string& key : {dxf_layer_key, dxf_material_key}) text = without(text, "1000\n" + key, "\n");
  const CutRock rock = read_again("blocks.dxf", without(text, "1001\nDDA", "\n"));
  ASSERT_EQ(rock.blocks.size(), 3U);
  EXPECT_EQ(rock.blocks[1].group, "tunnel___st");
  EXPECT_EQ(rock.blocks[1].shape.holes.size(), 1U);
  EXPECT_EQ(rock.blocks[1].material, "");
  EXPECT_EQ(rock.joints[1].joint, dxf_name("joint " + long_name).substr(6));
}

// The layer that somebody has put a line on counts, not the name of the one before.
TEST(WriteBlocks, DxfPutOnAnotherLayerIsOnThatLayer) {
  std::string text = block_file("blocks.dxf", three_blocks);
  const std::string line = "LINE\n8\n" + dxf_name("joint " + long_name);
  text.replace(text.find(line), line.size(), "LINE\n8\njoint_other");
  EXPECT_EQ(read_again("blocks.dxf", text).joints[1].joint, "other");
}

TEST(DxfNames, EveryCharacterComesBack) {
  for (const std::string name : {"plain", "back\\slash", "\\U+00F6", "\xC3\xB6 \xE2\x82\xAC \xF0\x9F\xAA\xA8", ""}) {
    const std::string escaped = dxf_escaped(name);
    EXPECT_TRUE(std::ranges::all_of(escaped, [](char c) { return c >= ' ' && c <= '~'; })) << escaped;
    EXPECT_EQ(dxf_unescaped(escaped), name);
  }
  EXPECT_EQ(dxf_escaped("\xC3\xB6"), "\\U+00F6");
  for (const std::string damaged : {"\\U+00F", "\\U+XYZW", "\\"}) EXPECT_EQ(dxf_unescaped(damaged), damaged);
  for (const std::string half : {"\\U+D83D", "\\U+DC00x", "\\U+D83D\\U+0041"})
    EXPECT_EQ(dxf_unescaped(half).front(), '?') << half;
}

std::string feature(const std::string& layer, const std::string& type, const std::string& coordinates) {
  return R"({"type": "Feature", "properties": {"layer": ")" + layer + R"("}, "geometry": {"type": ")" + type +
         R"(", "coordinates": )" + coordinates + "}}";
}

TEST(BlocksOfADrawing, WhatIsWrongIsSaidInOneSentence) {
  const std::string square = feature("Block-wall", "Polygon", "[[[0, 0], [2, 0], [2, 2], [0, 2], [0, 0]]]");
  const std::vector<std::pair<std::string, std::string>> all{
      {feature("block wall", "LineString", "[[0, 0], [2, 0], [2, 2]]"),
       "features[1] (layer block wall) is open, with ends 2.828 m apart, expected the outline of a block"},
      {feature("block wall", "Polygon", "[[[3, 0], [4, 1], [4, 0], [3, 1], [3, 0]]]"),
       "features[1] (layer block wall) is "},
      {feature("hole of wall", "Polygon", "[[[3, 0], [4, 1], [4, 0], [3, 0]]]"),
       "features[1] (layer hole of wall) is in no block of group \"wall\""},
      {feature("boundary", "Polygon", "[[[0, 0], [2, 0], [2, 2], [0, 2], [0, 0]]]"),
       "features[1] (layer boundary) is a line of layer boundary beside blocks"},
      {feature("rock", "LineString", "[[0, 0], [2, 2]]"), "is at (1, 1) m inside a block, expected a line along edges"},
      {feature("block wall", "Point", "[1, 1]"), "features[1] (layer block wall) is a point, expected lines"},
  };
  for (const auto& each : all) {
    const std::string text = R"({"type": "FeatureCollection", "features": [)" + square + ",\n" + each.first + "]}";
    expect_refused([&] { read_again("a.geojson", text); }, each.second);
  }
}

// Blocks that somebody takes away leave joints along which nothing touches any more.
TEST(BlocksOfADrawing, JointsThatNoBlocksHaveAreListed) {
  BlockDrawing drawing = three_blocks;
  drawing.blocks.erase(drawing.blocks.begin());
  const CutRock rock = read_again("a.geojson", block_file("a.geojson", drawing));
  EXPECT_EQ(rock.joints.size(), 1U);
  ASSERT_EQ(rock.cleaned.size(), 1U);
  EXPECT_EQ(rock.cleaned[0].what, Cleaning::line_not_used);
  EXPECT_EQ(rock.cleaned[0].origin, "a.geojson features[2] (layer joint default)");
}

TEST(LayersOfNames, BeginWithTheirWords) {
  EXPECT_EQ(named_layer("BLOCK_my wall")->name, "my wall");
  EXPECT_EQ(named_layer("hole-of rock")->role, LayerRole::block_hole);
  EXPECT_EQ(named_layer("joint bedding")->role, LayerRole::rock);
  for (const char* none : {"block", "block ", "blocks of", "joints", "hole point", "rock"})
    EXPECT_FALSE(named_layer(none)) << none;
}

// Lines on "joint NAME" are joints of that name in drawings that are to be cut, too.
TEST(LayersOfNames, NameJointsOfLinesThatCut) {
  const RockPlan plan = plan_of(read_csv_drawing("layer,x1,y1,x2,y2\nboundary,0,0,4,0\nboundary,4,0,0,4\n"
                                                 "boundary,0,4,0,0\njoint bedding,0,1,4,1\njoint default,0,2,4,2\n",
                                                 "a.csv", 0),
                                {});
  ASSERT_EQ(plan.lines.size(), 2U);
  EXPECT_EQ(plan.lines[0].joint, "bedding");
  EXPECT_EQ(plan.lines[1].joint, "");
}

}  // namespace
}  // namespace dda
