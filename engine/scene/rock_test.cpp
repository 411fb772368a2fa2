// Rock in scenes.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "engine/core/error.h"
#include "engine/core/temporary_folder.h"
#include "engine/cutting/opening_shapes.h"
#include "engine/scene/cut_scene.h"
#include "engine/scene/scene.h"
#include "engine/scene/scene_parts.h"

#include <fstream>

namespace dda {
namespace {

// A joint that nothing uses would be refused.
std::string scene_with(const std::string& rock, const std::string& more = "") {
  const bool has_bedding = rock.find("bed") != std::string::npos;
  return R"({"dda": 1, "materials": {"rock": {"density": 2600, "young": "20 GPa", "poisson": 0.25}},
 "joints": {"default": {"friction_angle": "35 deg"})" +
         std::string(has_bedding ? R"(, "bedding": {"friction_angle": "25 deg"})" : "") + R"(}, "blocks": {"rock": )" +
         rock + "}, " + more + R"( "steps": {"dt": "1 ms", "duration": "1 s"}})";
}

const std::string two_sets = R"({"boundary": [[0, 0], [20, 0], [20, 10], [0, 10]],
 "joint_sets": [{"dip": "20 deg", "spacing": "2 m", "joint": "bedding"},
                {"dip": {"mean": "80 deg", "deviation": "5 deg"}, "spacing": "3 m", "trace_length": "6 m",
                 "persistence": 0.8, "joint": "bedding"}],
 "lines": [{"points": [[0, 1], [20, 3]], "joint": "default"}],
 "openings": [{"name": "tunnel", "circle": {"centre": [10, 5], "radius": 2}}]})";

TEST(Rock, BlocksHaveNamesGroupsAndJoints) {
  const Model model = parse_scene(scene_with(two_sets, R"("fixed": ["tunnel"],)"), "rock.json");
  EXPECT_GT(model.blocks.size(), 40U);
  const auto named = [&](const char* start) {
    return std::count_if(model.blocks.begin(), model.blocks.end(),
                         [&](const Block& block) { return block.name.rfind(start, 0) == 0; });
  };
  EXPECT_GT(named("tunnel "), 1);
  EXPECT_EQ(named("tunnel ") + named("rock "), static_cast<long>(model.blocks.size()));
  EXPECT_EQ(static_cast<long>(model.held_blocks.size()), named("tunnel "));
  ASSERT_FALSE(model.joint_lines.empty());
  EXPECT_EQ(model.joints[static_cast<std::size_t>(model.joint_lines[0].joint)].name, "bedding");
}

void expect_same(const Model& a, const Model& b) {
  ASSERT_EQ(a.blocks.size(), b.blocks.size());
  for (std::size_t i = 0; i < a.blocks.size(); ++i) {
    EXPECT_EQ(a.blocks[i].name, b.blocks[i].name);
    EXPECT_EQ(a.blocks[i].shape.outer, b.blocks[i].shape.outer);
    EXPECT_EQ(a.blocks[i].shape.holes, b.blocks[i].shape.holes);
    EXPECT_EQ(a.blocks[i].initial_stress, b.blocks[i].initial_stress);
  }
  ASSERT_EQ(a.joint_lines.size(), b.joint_lines.size());
  for (std::size_t i = 0; i < a.joint_lines.size(); ++i) {
    EXPECT_EQ(a.joint_lines[i].from, b.joint_lines[i].from);
    EXPECT_EQ(a.joint_lines[i].to, b.joint_lines[i].to);
    EXPECT_EQ(a.joint_lines[i].joint, b.joint_lines[i].joint);
  }
  EXPECT_EQ(a.held_blocks.size(), b.held_blocks.size());
}

TEST(Rock, TheSceneThatIsWrittenOutGivesTheSame) {
  const TemporaryFolder folder;
  std::string rock = two_sets;
  rock.insert(1, R"("initial_stress": {"yy": "-1 MPa"}, )");
  const std::string text = scene_with(rock, R"("fixed": ["tunnel"],)");
  std::ofstream(folder / "scene.json") << text;
  const CutScene cut = cut_scene(folder / "scene.json", folder / "out");
  ASSERT_EQ(cut.entries.size(), 1U);
  expect_same(parse_scene(text, "rock.json"), parse_scene(cut.text, "cut.json"));
}

TEST(Rock, AJointWithoutAnyContactLeavesTheSceneThatIsWrittenOut) {
  const TemporaryFolder folder;
  std::ofstream(folder / "scene.json") << scene_with(
      R"({"boundary": [[0, 0], [1, 0], [1, 1], [0, 1]], "lines": [{"points": [[0.2, 0.2], [0.4, 0.4]], "joint": "bedding"}]})");
  const CutScene cut = cut_scene(folder / "scene.json", folder / "out");
  EXPECT_EQ(parse_scene(cut.text, "cut.json").blocks.size(), 1U);
}

const std::string filled = R"({"boundary": [[0, 0], [20, 0], [20, 20], [0, 20]],
 "openings": [{"name": "tunnel", "circle": {"centre": [10, 10], "radius": 2}, "left_out": true,
               "rings": {"count": 2, "thickness": "0.4 m", "cuts": 16, "joint": "bedding"}}],
 "fill": [{"voronoi": {"size": "2 m", "graded": {"opening": "tunnel", "size": "0.5 m"}}, "joint": "bedding"}]})";

// Joints that end where a wall, an opening and a line meet have no length but that of round-off.
TEST(Rock, AFilledSceneThatIsWrittenOutGivesTheSame) {
  const TemporaryFolder folder;
  for (const char* seed : {"1", "2", "3"}) {
    std::string rock = filled;
    rock.insert(
        1, std::string(R"("seed": )") + seed + R"(, "lines": [{"points": [[-1, 9], [21, 12]], "joint": "default"}], )");
    const std::string text = scene_with(rock);
    std::ofstream(folder / "scene.json") << text;
    expect_same(parse_scene(text, "rock.json"),
                parse_scene(cut_scene(folder / "scene.json", folder / "out").text, "cut.json"));
  }
}

TEST(Rock, FillsAndRingsCutAndHaveTheirJoint) {
  const Model model = parse_scene(scene_with(filled), "rock.json");
  // 2 rings of 16 blocks; beyond them the integral of 1/size^2, with size = 0.5 + 0.2 (r - 2) up to 2 at r = 9.5 and
  // the corners of the square in cells of 4 m2, is 187. The outline of rounded blocks makes a few more or less.
  EXPECT_NEAR(static_cast<double>(model.blocks.size()), 32 + 187, 0.05 * 187);
  double area = 0;
  for (const Block& block : model.blocks) area += block.moments.area;
  const double tunnel = area_moments({circle({10, 10}, 2, 0.02), {}}).area;
  EXPECT_NEAR(area, 400 - tunnel, 1e-10);
  for (const JointLine& line : model.joint_lines)
    EXPECT_EQ(model.joints[static_cast<std::size_t>(line.joint)].name, "bedding");
  std::string other = filled;
  other.replace(other.find("\"size\": \"2 m\""), 13, "\"seed\": 5, \"size\": \"2 m\"");
  EXPECT_NE(parse_scene(scene_with(other), "rock.json").blocks[0].moments.area, model.blocks[0].moments.area);
}

struct Refused {
  std::string rock;
  std::string sentence;
};

TEST(Rock, WrongRockIsRefusedInOneSentence) {
  const std::string square = R"("boundary": [[0, 0], [10, 0], [10, 10], [0, 10]])";
  const auto set = [&](const std::string& keys) { return "{" + square + R"(, "joint_sets": [{)" + keys + "}]}"; };
  const auto fill = [&](const std::string& keys) {
    return "{" + square +
           R"(, "openings": [{"name": "t", "circle": {"centre": [5, 5], "radius": 1}}], "fill": [{"joint": "bedding", "voronoi": {)" +
           keys + "}}]}";
  };
  const auto rings = [&](const std::string& keys) {
    return "{" + square +
           R"(, "openings": [{"name": "t", "polygon": [[1, 1], [9, 1], [9, 9], [6, 9], [6, 2], [5, 2], [5, 9], [1, 9]], "rings": {"joint": "bedding", )" +
           keys + "}}]}";
  };
  const std::vector<Refused> all{
      {R"({"boundary": [[0, 0], [10, 10], [10, 0], [0, 10]]})",
       "blocks.rock.boundary is self-intersecting: edge 0 of the outer ring crosses or touches edge 2, expected a "
       "closed "
       "line that does not meet itself"},
      {R"({"boundary": [[0, 0], [10, 10]]})", "blocks.rock.boundary is"},
      {"{" + square + R"(, "lines": [{"points": [[0, 5], [10, 5]], "joint": "beding"}]})",
       "blocks.rock.lines[0].joint is \"beding\", expected one of \"default\", \"bedding\" (perhaps \"bedding\")"},
      {set(R"("dip": 0, "spacing": "2 m")"), "blocks.rock.joint_sets[0].joint is missing"},
      {set(R"("dip": 0, "spacing": "0 m", "joint": "bedding")"),
       "blocks.rock.joint_sets[0].spacing is \"0 m\", expected a length above 0"},
      {set(R"("dip": 0, "spacing": {"mean": -1, "deviation": 1}, "joint": "bedding")"),
       "blocks.rock.joint_sets[0].spacing.mean is -1, expected a length above 0"},
      {set(R"("dip": 0, "spacing": "1 um", "joint": "bedding")"),
       "blocks.rock.joint_sets[0] is a set of more than 2000000 traces"},
      {set(R"("dip": 0, "spacing": 1, "persistence": 0.5, "joint": "bedding")"),
       "blocks.rock.joint_sets[0].persistence is 0.5, expected together with a trace_length"},
      {set(R"("dip": 0, "spacing": 1, "ends_at": ["cross"], "joint": "bedding")"),
       "blocks.rock.joint_sets[0].ends_at is \"cross\", expected the name of an earlier set"},
      {"{" + square +
           R"(, "openings": [{"name": "tunnel", "circle": {"centre": [50, 5], "radius": 2}, "joint": "bedding"}]})",
       "blocks.rock.openings[0] is \"tunnel\" around (50, 5) m, outside the rock, expected an opening inside the "
       "boundary"},
      {"{" + square +
           R"(, "openings": [{"name": "t", "circle": {"centre": [5, 5], "radius": 20}, "joint": "bedding"}]})",
       "blocks.rock.openings[0] is \"t\" around all of the rock, expected an opening that leaves some of it"},
      {"{" + square +
           R"(, "openings": [{"name": "t", "rectangle": {"foot": [5, -10], "width": 30, "height": 30}, "left_out": true, "joint": "bedding"}]})",
       "blocks.rock.openings[0] is \"t\" around all of the rock, expected an opening that leaves some of it"},
      {"{" + square +
           R"(, "openings": [{"name": "t", "rectangle": {"foot": [5, 0], "width": 10, "height": 10}, "left_out": true, "joint": "bedding"}]})",
       "blocks.rock.openings is around all of the rock, expected openings that leave some of it"},
      {"{" + square + R"(, "tolerance": "12 m", "lines": [{"points": [[0, 5], [10, 5]], "joint": "bedding"}]})",
       "blocks.rock.tolerance is 12 m, expected a smaller length"},
      {"{" + square + R"(, "tolerance": 1e308, "lines": [{"points": [[0, 5], [10, 5]], "joint": "bedding"}]})",
       "blocks.rock.tolerance is 1e+308 m, expected a smaller length"},
      {"{" + square + R"(, "openings": [{"name": "rock", "circle": {"centre": [5, 5], "radius": 2}}]})",
       "blocks.rock.openings[0].name is \"rock\", expected another name than that of the rock's own group"},
      {"{" + square +
           R"(, "openings": [{"name": "t", "circle": {"centre": [5, 5], "radius": 2}, "chord_tolerance": 1e-7}]})",
       "blocks.rock.openings[0].chord_tolerance is 1e-07, expected at least 2e-06 m, 1e-06 of the radius"},
      {"{" + square + R"(, "openings": [{"name": "tunnel", "joint": "bedding"}]})",
       "blocks.rock.openings[0] is without a shape"},
      {"{" + square + R"(, "openings": [{"name": "t", "horseshoe": {"width": 4, "height": 6}, "joint": "bedding"}]})",
       "blocks.rock.openings[0].horseshoe.height is 6, expected 0.5 to 1.36 of the width"},
      {fill(R"("size": "1 um")"), "blocks.rock.fill[0] is more than 100000 cells in one block, expected a larger size"},
      {fill(R"("size": 0)"), "blocks.rock.fill[0].voronoi.size is 0, expected a number above 0"},
      {fill(R"("relax": 3)"), "blocks.rock.fill[0].voronoi.size is missing"},
      {fill(R"("size": 1, "short_edge": 0.5)"), "blocks.rock.fill[0].voronoi.short_edge is 0.5, expected"},
      {fill(R"("size": 1, "graded": {"opening": "tunnel", "size": 0.1})"),
       "blocks.rock.fill[0].voronoi.graded.opening is \"tunnel\", expected the name of an opening of this rock"},
      {fill(R"("size": 1, "graded": {"size": 2})"),
       "blocks.rock.fill[0].voronoi.graded.size is 2, expected at most the size of cells elsewhere"},
      {fill(R"("size": 1, "graded": {"size": 0.2, "growth": 3})"),
       "blocks.rock.fill[0].voronoi.graded.growth is 3, expected at most 1"},
      {"{" + square + R"(, "seed": 2147483648})",
       "blocks.rock.seed is 2147483648, expected 0 or more and at most 2147483647"},
      {fill(R"("size": 1, "seed": 9223372036854775808)"),
       "blocks.rock.fill[0].voronoi.seed is 9223372036854775808, expected 0 or more and at most 2147483647"},
      {rings(R"("count": 2, "thickness": 0.4, "cuts": 10000000)"),
       "blocks.rock.openings[0].rings.cuts is 10000000, expected 1 or more and at most 10000"},
      {rings(R"("count": 2, "thickness": 0.4)"),
       "blocks.rock.openings[0].rings is 0.8 m away from the outline self-intersecting"},
  };
  for (const Refused& each : all) {
    try {
      parse_scene(scene_with(each.rock), "rock.json");
      ADD_FAILURE() << each.sentence;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find(each.sentence), std::string::npos) << error.what() << "\nexpected\n"
                                                                                  << each.sentence;
    }
  }
}

std::vector<std::string> remarks_of_sets(const std::string& sets) {
  const std::string rock = R"({"boundary": [[0, 0], [10, 0], [10, 10], [0, 10]], "joint_sets": [)" + sets + "]}";
  return parse_scene_parts(scene_with(rock), "rock.json").remarks;
}

// A set that lies beside the rock, whose next line does, or whose traces all do. Traces that end within a block cut
// nothing either, but that is listed as cleaned.
TEST(Rock, SetsWithoutAJointInTheRockAreRemarkedOn) {
  const std::string whole = R"({"dip": 0, "spacing": "4 m", "start": [0, 3], "joint": "bedding"})";
  const std::string said = " has no joint in the rock: its spacing, start, trace length or region leaves none there";
  EXPECT_TRUE(remarks_of_sets(whole).empty());
  for (const char* none :
       {R"("spacing": "1 m", "region": [[50, 50], [60, 50], [60, 60]])", R"("spacing": "1 km", "start": [5, 500])",
        R"("spacing": "1 km", "trace_length": "3 m", "bridge": "90 m", "start": [30, 5])"}) {
    const std::string set = R"({"dip": "1 deg", "joint": "bedding", )" + std::string(none) + "}";
    EXPECT_EQ(remarks_of_sets(whole + ", " + set),
              std::vector<std::string>{"cutting \"rock\": blocks.rock.joint_sets[1] (\"set 2\")" + said})
        << none;
  }
  const auto named =
      remarks_of_sets(R"({"name": "J1", "dip": 0, "spacing": "1 km", "start": [0, 500], "joint": "bedding"})");
  ASSERT_EQ(named.size(), 1U);
  EXPECT_EQ(named[0], "cutting \"rock\": blocks.rock.joint_sets[0] (\"J1\")" + said);
  for (const std::string& remark : remarks_of_sets(
           R"({"dip": 0, "spacing": "2 m", "trace_length": "3 m", "persistence": 0.5, "joint": "bedding"})"))
    EXPECT_EQ(remark.find("no joint"), std::string::npos) << remark;
}

const std::string square_with_joint =
    "layer,x1,y1,x2,y2,x,y\nUmriss,0,0,4000,0,,\nUmriss,4000,0,4000,4000,,\n"
    "Umriss,4000,4000,0,4000,,\nUmriss,0,4000,0,0,,\nFuge,0,1000,4000,2000,,\n";
const std::string its_layers = R"("layers": {"Umriss": "boundary", "fuge": {"as": "rock", "joint": "bedding"}})";

// The drawing is written as plan.csv beside the scene.
Model model_of_drawing(const TemporaryFolder& folder, const std::string& drawing, const std::string& rock) {
  std::ofstream(folder / "plan.csv") << drawing;
  return parse_scene(scene_with(rock), "rock.json", folder.path());
}

TEST(RockOfADrawing, LayersHaveJointsAndTheSceneAddsToThem) {
  const TemporaryFolder folder;
  const std::string drawing = R"({"drawing": {"file": "plan.csv", "unit": "mm", )" + its_layers + "}";
  const Model model = model_of_drawing(folder, square_with_joint, drawing + "}");
  ASSERT_EQ(model.blocks.size(), 2U);
  EXPECT_NEAR(model.blocks[0].moments.area + model.blocks[1].moments.area, 16, 1e-12);
  ASSERT_EQ(model.joint_lines.size(), 1U);
  EXPECT_EQ(model.joint_lines[0].from.x() + model.joint_lines[0].to.x(), 4);
  const std::string more = R"(, "lines": [{"points": [[1, -1], [1, 5]], "joint": "default"}]})";
  EXPECT_EQ(model_of_drawing(folder, square_with_joint, drawing + more).blocks.size(), 4U);
}

TEST(RockOfADrawing, WhatDoesNotFitIsRefusedInOneSentence) {
  const TemporaryFolder folder;
  const std::string boundary = R"("boundary": [[0, 0], [1, 0], [1, 1]])";
  const auto drawn = [](const std::string& keys) { return R"({"drawing": {"file": "plan.csv", )" + keys + "}"; };
  const std::string open = square_with_joint.substr(0, square_with_joint.find("Umriss,0,4000"));
  struct Wrong {
    std::string drawing, rock, sentence;
  };
  const std::vector<Wrong> all{
      {"", R"({"drawing": "plan.dxf"})", "rock.json: plan.dxf is missing, expected a drawing"},
      {"", R"({"drawing": "plan.pdf"})",
       "rock.json: the drawing is \"plan.pdf\", expected a .dxf, .csv, .xlsx, .geojson, .dc, .geo, .blck or .blk file"},
      {"", R"({"joint_sets": []})", "rock.json: blocks.rock.boundary is missing, expected it, or a drawing"},
      {square_with_joint, R"({"drawing": "plan.csv"})",
       "rock.json: plan.csv line 2 is on the unknown layer \"Umriss\""},
      {square_with_joint, drawn(its_layers) + ", " + boundary + "}",
       "blocks.rock.boundary is given beside that of the drawing, of plan.csv line 2 (layer Umriss), expected one of "
       "the "
       "two"},
      {square_with_joint, drawn(R"("layers": {"Umris": "boundary"})") + "}",
       "blocks.rock.drawing.layers.Umris is for a layer on which nothing is drawn, expected a layer of plan.csv"},
      {square_with_joint, drawn(R"("layers": {"Umriss": "bondary"})") + "}",
       "blocks.rock.drawing.layers.Umriss is \"bondary\", expected one of"},
      {square_with_joint, drawn(R"("layers": {"Fuge": {"as": "rock", "joint": "bed"}})") + "}",
       "blocks.rock.drawing.layers.Fuge.joint is \"bed\", expected"},
      {square_with_joint, drawn(R"("unit": "kg")") + "}", "blocks.rock.drawing.unit is \"kg\", expected one of"},
      {open, drawn(R"("layers": {"Umriss": "boundary"})") + "}",
       "plan.csv line 4 (layer Umriss) is open at (0, 4000) m, 4000 m from the nearest other end, of plan.csv line 2"},
  };
  for (const Wrong& wrong : all) {
    try {
      model_of_drawing(folder, wrong.drawing, wrong.rock);
      ADD_FAILURE() << wrong.sentence;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find(wrong.sentence), std::string::npos) << error.what() << "\nexpected\n"
                                                                                   << wrong.sentence;
    }
  }
}

TEST(RockOfADrawing, ADrawingAloneBecomesASceneThatRuns) {
  const TemporaryFolder folder;
  std::ofstream(folder / "plan.csv")
      << "layer,x1,y1,x2,y2,x,y\nboundary,0,0,4,0,,\nboundary,4,0,4,4,,\nboundary,4,4,0,4,,\n"
         "boundary,0,4,0,0,,\nrock,0,1,4,2,,\nfix point,,,,,0,1\nmeasure point,,,,,2,3\n"
         "load point,,,,,4,4\n";
  const CutScene cut = cut_scene(folder / "plan.csv", folder / "out");
  const Model model = parse_scene(cut.text, "cut.json");
  EXPECT_EQ(model.blocks.size(), 2U);
  EXPECT_EQ(model.supports.size(), 2U);  // the point lies on both blocks
  EXPECT_EQ(model.measurements.size(), 2U);
  EXPECT_NE(cut.text.find("Load points: 1"), std::string::npos);
}

}  // namespace
}  // namespace dda
