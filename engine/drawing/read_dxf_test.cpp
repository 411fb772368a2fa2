// DXF files that another program wrote (fixtures/make_fixtures.py), and what is wrong with a file.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "engine/cutting/cut_rock.h"
#include "engine/drawing/drawing_test_support.h"
#include "engine/drawing/read_drawing.h"
#include "engine/drawing/read_formats.h"
#include "engine/drawing/straighten.h"
#include "engine/geometry/box.h"
#include "engine/geometry/segment.h"

namespace dda {
namespace {

TEST(ReadDxf, AllLayersOfTheThesis) {
  const LineDrawing drawing = read_drawing(fixture("tunnel.dxf"), "tunnel.dxf");
  EXPECT_EQ(drawing.unit, "mm");
  EXPECT_EQ(drawing.passed_over, (std::map<std::string, int>{{"TEXT", 1}}));
  const RockPlan plan = plan_of(drawing, {});
  EXPECT_NEAR(std::abs(signed_area(plan.boundary)), 400, 1e-9);
  EXPECT_EQ(plan.lines.size(), 4U);
  ASSERT_EQ(plan.openings.size(), 2U);
  EXPECT_EQ(plan.openings[0].name, "tunnel");
  EXPECT_TRUE(plan.openings[0].left_out);  // a hole point lies in it
  EXPECT_EQ(plan.openings[1].name, "blast");
  EXPECT_FALSE(plan.openings[1].left_out);
  ASSERT_EQ(plan.points.size(), 4U);
  EXPECT_EQ(plan.points[3].name, "measure point 1");
  EXPECT_EQ(plan.points[3].at, Vec2(0, 4));
  ASSERT_EQ(plan.marks.size(), 2U);
  EXPECT_EQ(plan.marks[0].points.front(), Vec2(10, 10));
}

// The wall of the tunnel is a polygon, and joints that end on the circle end on the polygon.
TEST(ReadDxf, JointsReachTheChordsOfArcs) {
  const LineDrawing drawing = read_drawing(fixture("tunnel.dxf"), "tunnel.dxf");
  const CutRock rock = cut_rock(plan_of(drawing, {}));
  EXPECT_EQ(rock.blocks.size(), 5U);  // three sectors, one of them parted by the level joint, and the place of blasting
  EXPECT_EQ(rock.dangles_trimmed, 0);
}

// A fix point on the wall of a tunnel lies in the rock.
TEST(ReadDxf, PointsOnArcsAreCornersOfTheirChords) {
  LineDrawing drawing = read_drawing(fixture("tunnel.dxf"), "tunnel.dxf");
  const Vec2 on_wall = 3 * Vec2(std::cos(1.0), std::sin(1.0));
  drawing.points.push_back({"fix point", "here", on_wall});
  const RockPlan plan = plan_of(drawing, {});
  EXPECT_EQ(std::ranges::count(plan.openings[0].outline, on_wall), 1);
}

// m, from a point to the nearest stretch of a line.
double distance_to(const std::vector<Vec2>& line, const Vec2& point) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < line.size(); ++i) least = std::min(least, distance(Segment{line[i - 1], line[i]}, point));
  return least;
}

double length_of(const std::vector<Vec2>& line) {
  double sum = 0;
  for (std::size_t i = 1; i < line.size(); ++i) sum += (line[i] - line[i - 1]).norm();
  return sum;
}

// Curves as another program flattens them, each to 1 mm.
std::map<int, std::vector<Vec2>> flattened_elsewhere() {
  const std::string text = text_of_fixture("shapes_points.csv");
  std::map<int, std::vector<Vec2>> curves;
  for (std::size_t at = text.find('\n') + 1; at < text.size(); at = text.find('\n', at) + 1) {
    const std::size_t first = text.find(',', text.find(',', at) + 1) + 1;
    const std::size_t second = text.find(',', first) + 1;
    curves[std::stoi(text.substr(at))].emplace_back(std::stod(text.substr(first)), std::stod(text.substr(second)));
  }
  return curves;
}

// Both are within their tolerance of the curve. A chord of sag s is shorter than its arc by 8/3 s^2 over its length, so
// lengths agree to the same order.
TEST(ReadDxf, CurvesAndSymbolsAreThoseOfAnotherProgram) {
  const LineDrawing drawing = read_drawing(fixture("shapes.dxf"), "shapes.dxf");
  constexpr double sag = 1e-3;
  const std::vector<std::vector<Vec2>> ours = straightened(drawing, {sag, 0}, 1e-6);
  const std::map<int, std::vector<Vec2>> theirs = flattened_elsewhere();
  ASSERT_EQ(ours.size(), theirs.size());
  for (const auto& [number, points] : theirs) {
    const auto& line = ours[static_cast<std::size_t>(number)];
    for (const Vec2& point : points) EXPECT_LE(distance_to(line, point), 2 * sag) << "curve " << number;
    for (const Vec2& point : line) EXPECT_LE(distance_to(points, point), 2 * sag) << "curve " << number;
    EXPECT_NEAR(length_of(line), length_of(points), 0.002 * length_of(points)) << "curve " << number;
  }
}

TEST(ReadDxf, ChordsStayWithinTheirTolerance) {
  const LineDrawing drawing = read_drawing(fixture("shapes.dxf"), "shapes.dxf");
  const std::map<int, std::vector<Vec2>> theirs = flattened_elsewhere();
  for (const double sag : {0.2, 0.05, 0.01}) {
    const auto ours = straightened(drawing, {sag, 0}, 1e-6);
    for (const auto& [number, points] : theirs) {
      for (const Vec2& point : points)
        EXPECT_LE(distance_to(ours[static_cast<std::size_t>(number)], point), sag + 1e-3) << "curve " << number;
    }
  }
}

TEST(ReadDxf, OldestRelease) {
  const RockPlan plan = plan_of(read_drawing(fixture("release_12.dxf"), "release_12.dxf"), {});
  EXPECT_EQ(std::abs(signed_area(plan.boundary)), 8);
  EXPECT_EQ(cut_rock(plan).blocks.size(), 2U);
}

TEST(ReadDxf, AUnitThatIsGivenGoesBeforeTheHeader) {
  const LineDrawing drawing = read_drawing(fixture("tunnel.dxf"), "tunnel.dxf", 0.01);
  EXPECT_NEAR(std::abs(signed_area(plan_of(drawing, {}).boundary)), 40000, 1e-6);
}

std::string dxf(const std::string& entities) { return "0\nSECTION\n2\nENTITIES\n" + entities + "0\nENDSEC\n0\nEOF\n"; }

std::string line(const std::string& layer, double x1, double y1, double x2, double y2) {
  return "0\nLINE\n8\n" + layer + "\n10\n" + std::to_string(x1) + "\n20\n" + std::to_string(y1) + "\n11\n" +
         std::to_string(x2) + "\n21\n" + std::to_string(y2) + "\n";
}

std::string square(double from, double to, const std::string& layer = "boundary") {
  return line(layer, from, from, to, from) + line(layer, to, from, to, to) + line(layer, to, to, from, to) +
         line(layer, from, to, from, from);
}

TEST(ReadDxf, WhatIsWrongIsSaidInOneSentence) {
  const std::string in_itself =
      "0\nSECTION\n2\nBLOCKS\n0\nBLOCK\n2\nA\n0\nINSERT\n8\nrock\n2\nA\n10\n0\n20\n0\n0\nENDBLK\n0\nENDSEC\n" +
      dxf("0\nINSERT\n8\nrock\n2\nA\n10\n0\n20\n0\n");
  const std::vector<std::pair<std::string, std::string>> all{
      {"AutoCAD Binary DXF\r\n", "plan.dxf is binary DXF, expected DXF as text"},
      {"AC1027xxx", "plan.dxf is a DWG file, expected DXF as text"},
      {"", "plan.dxf line 0 is the last one, expected more, up to EOF"},
      {"0\nSECTION\n2\nENTITIES\n0\nLINE\n",
       "plan.dxf line 6 is the last one, expected more, up to EOF: the file is cut"},
      {"hello\nworld\n", "plan.dxf line 1 is \"hello\", expected a group code of DXF"},
      {dxf("0\nLINE\n8\nrock\n10\n1,5\n"), "plan.dxf line 6 (LINE), group 10 in line 10 is \"1,5\", expected a finite"},
      {dxf("0\nLINE\n8\nrock\n10\nnan\n"), "is \"nan\", expected a finite number"},
      {dxf("0\nLINE\n8\nrock\n10\n1e13\n20\n0\n11\n0\n21\n0\n"),
       "plan.dxf line 6 is at (1e+13, 0) m, expected finite coordinates"},
      {dxf("0\nINSERT\n8\nrock\n2\nA\n"), "plan.dxf line 6 (INSERT) is symbol \"A\", expected a block of the drawing"},
      {in_itself, "(INSERT) is symbols in symbols more than 16 deep"},
      {dxf("0\nCIRCLE\n8\ntunnel\n40\n0\n"), "plan.dxf line 6 (CIRCLE) is of radius 0, expected a radius above 0"},
      {dxf("0\nSPLINE\n8\nrock\n71\n3\n"),
       "(SPLINE) is a spline without points, expected control points or fit points"},
      {dxf("0\nSPLINE\n8\nrock\n11\n0\n21\n0\n"), "(SPLINE) is of 1 fit points, expected two different ones or more"},
      {dxf("0\nCIRCLE\n8\ntunnel\n40\n1\n210\n1\n230\n0\n"), "is drawn in a plane that is not that of x and y"},
      {dxf(square(0, 4) + line("Dim", 0, 0, 1, 1)),
       "plan.dxf line 54 is on the unknown layer \"Dim\", expected one of boundary, rock, tunnel"},
      {dxf(line("boundary", 0, 0, 4, 0) + line("boundary", 4, 0, 4, 4) + line("boundary", 4, 4, 0, 0.5)),
       "plan.dxf line 30 (layer boundary) is open at (0, 0.5) m, 0.5 m from the nearest other end, of plan.dxf line 6 "
       "(layer boundary), expected a closed line"},
      {dxf(square(0, 4) + line("boundary", 0, 0, 2, 2)), "is one of 3 lines that meet at (0, 0) m"},
      {dxf(square(0, 4) + square(5, 6)), "is a second outline, outside of the first"},
      {dxf(square(0, 4) + line("tunnel", 1, 1, 2, 2)), "(layer tunnel) is open at"},
      {dxf(square(0, 4) + line("measure point", 1, 1, 2, 2)), "(layer measure point) is a line, expected points"},
      {dxf(square(0, 4) + "0\nPOINT\n8\nrock\n10\n1\n20\n1\n"), "(layer rock) is a point, expected lines"},
      {dxf(square(0, 4) + "0\nPOINT\n8\nhole point\n10\n1\n20\n1\n"), "is at (1, 1) m, in no opening"},
      {dxf(square(0, 4) + line("absorbing boundary", 0, 1, 4, 1)),
       "(layer absorbing boundary) is at (2, 1) m, off the boundary"},
  };
  for (const auto& each : all) expect_refused([&] { plan_of(read_dxf(each.first, "plan.dxf", 0), {}); }, each.second);
}

// Read as zero, what is missing would be a line to the origin, an arc of a whole turn, or a point elsewhere.
TEST(ReadDxf, WhatAnEntityMustHaveIsNotGuessed) {
  const std::string missing = "expected all coordinates, radii and angles that its type has";
  const std::vector<std::pair<std::string, std::string>> all = {
      {"LINE\n8\nrock\n10\n1\n20\n1\n", "without group 11"},
      {"LINE\n8\nrock\n10\n1\n20\n1\n11\n3\n", "without group 21"},
      {"LINE\n8\nrock\n20\n1\n11\n3\n21\n3\n", "without group 10"},
      {"POINT\n8\nmeasure point\n10\n1\n", "without group 20"},
      {"CIRCLE\n8\ntunnel\n40\n1\n", "without group 10"},
      {"CIRCLE\n8\ntunnel\n10\n2\n20\n2\n", "without group 40"},
      {"ARC\n8\nrock\n10\n2\n20\n2\n40\n1\n51\n90\n", "without group 50"},
      {"ARC\n8\nrock\n10\n2\n20\n2\n40\n1\n50\n0\n", "without group 51"},
      {"ELLIPSE\n8\nrock\n10\n2\n20\n2\n40\n0.5\n", "without group 11"},
      {"ELLIPSE\n8\nrock\n10\n2\n20\n2\n11\n1\n21\n0\n", "without group 40"},
      {"POLYLINE\n8\nrock\n0\nVERTEX\n10\n1\n20\n1\n0\nVERTEX\n10\n2\n0\nSEQEND\n", "(VERTEX) is without group 20"}};
  for (const auto& [entity, value] : all)
    expect_refused([&] { read_dxf(dxf(square(0, 4) + "0\n" + entity), "plan.dxf", 0); }, value + ", " + missing);
}

TEST(ReadDxf, CornersOfAPolylineAreAsManyAsItSays) {
  const std::string corners = "8\nrock\n10\n1\n20\n1\n10\n2\n20\n2\n";
  const auto read = [&](const std::string& more) {
    return read_dxf(dxf(square(0, 4) + "0\nLWPOLYLINE\n" + more), "plan.dxf", 0);
  };
  EXPECT_EQ(read("90\n2\n" + corners).lines.size(), read(corners).lines.size());
  expect_refused([&] { read("90\n3\n" + corners); }, "is of 2 corners, and says that it has 3");
  expect_refused([&] { read("90\n3\n" + corners + "10\n3\n"); }, "is with a corner that has no group 20");
}

std::string fit_points(const std::vector<Vec2>& points, int flags, const std::string& more = "") {
  std::string text = "0\nSPLINE\n8\ntunnel\n70\n" + std::to_string(flags) + "\n71\n3\n" + more;
  for (const Vec2& p : points) text += "11\n" + std::to_string(p.x()) + "\n21\n" + std::to_string(p.y()) + "\n";
  return text;
}

// The curve through 16 points of a circle leaves it by 5/384 (2 pi/16)^4 = 3.1e-4 of the radius at most, its chords the
// curve by 1e-3 m: 2 pi r times both is 0.0083 m2; to_string leaves coordinates of six digits.
TEST(ReadDxf, ASplineOfFitPointsAloneIsTheCubicThroughThem) {
  std::vector<Vec2> points;
  for (int i = 0; i < 16; ++i)
    points.emplace_back(2 + std::cos(i * std::numbers::pi / 8), 2 + std::sin(i * std::numbers::pi / 8));
  DrawingOptions options;
  options.chords.length = 1e-3;
  const RockPlan plan = plan_of(read_dxf(dxf(square(0, 4) + fit_points(points, 1)), "plan.dxf", 0), options);
  ASSERT_EQ(plan.openings.size(), 1U);
  EXPECT_NEAR(std::abs(signed_area(plan.openings[0].outline)), std::numbers::pi, 0.0083);
}

TEST(ReadDxf, ControlPointsGoBeforeFitPoints) {
  const std::string control =
      "40\n0\n40\n0\n40\n0\n40\n0\n40\n1\n40\n1\n40\n1\n40\n1\n"
      "10\n0\n20\n0\n10\n1\n20\n0\n10\n2\n20\n0\n10\n3\n20\n0\n";
  const LineDrawing drawing = read_dxf(dxf(fit_points({{0, 0}, {1, 5}, {3, 0}}, 0, control)), "plan.dxf", 0);
  ASSERT_EQ(drawing.lines.size(), 1U);
  ASSERT_EQ(drawing.lines[0].pieces.size(), 1U);
  EXPECT_EQ(drawing.lines[0].pieces[0].curve->at(0.5), Vec2(1.5, 0));
}

TEST(ReadDxf, ATunnelOutsideOfTheRockIsRefusedWithItsLine) {
  const std::string text = dxf(square(0, 4) + square(7, 8, "tunnel"));
  expect_refused([&] { cut_rock(plan_of(read_dxf(text, "plan.dxf", 0), {})); },
                 "plan.dxf line 54 (layer tunnel) is \"tunnel\" around (7.5, 7.5) m, outside the rock");
}

TEST(ReadDxf, LinesDrawnTwiceCountOnceAndGapsWithinReachClose) {
  const RockPlan plan = plan_of(read_dxf(dxf(square(0, 4) + square(0, 4)), "plan.dxf", 0), {});
  EXPECT_EQ(plan.boundary.size(), 4U);
  DrawingOptions options;
  options.reach = 0.6;
  const std::string gap = line("boundary", 0, 0, 4, 0) + line("boundary", 4, 0, 4, 4) + line("boundary", 4, 4, 0, 0.5);
  EXPECT_EQ(plan_of(read_dxf(dxf(gap), "plan.dxf", 0), options).boundary.size(), 3U);
}

TEST(ReadDxf, OpeningsOfALayerAreNumberedFromLeftToRight) {
  const RockPlan plan =
      plan_of(read_dxf(dxf(square(0, 9) + square(6, 7, "tunnel") + square(1, 2, "tunnel")), "p", 0), {});
  ASSERT_EQ(plan.openings.size(), 2U);
  EXPECT_EQ(plan.openings[0].name, "tunnel 1");
  EXPECT_EQ(bounding_box(plan.openings[0].outline).lower, Vec2(1, 1));
}

}  // namespace
}  // namespace dda
