// CSV, GeoJSON, and what is written for other programs.
#include <nlohmann/json.hpp>

#include "engine/drawing/drawing_test_support.h"
#include "engine/drawing/read_formats.h"
#include "engine/drawing/write_blocks.h"

namespace dda {
namespace {

TEST(ReadCsv, LinesAndPointsOfTheThesis) {
  expect_triangle_with_joint(
      read_csv_drawing("\xEF\xBB\xBFLayer,x1,y1,x2,y2,x,y\r\nboundary,0,0,4,0,,\r\nBoundary,4,0,0,4,,\r\n"
                       "boundary,0,4,0,0,,\r\n# a joint\r\nrock,0,1.5,4,1.5,,\r\nfix point,,,,,0.5,0.25\r\n",
                       "plan.csv", 0));
}

TEST(ReadCsv, AsSpreadsheetsWithDecimalCommasAndProgramsOfDrawingWriteIt) {
  expect_triangle_with_joint(
      read_csv_drawing("Count;Name;End X;End Y;Layer;Position X;Position Y;Start X;Start Y\n"
                       "1;Line;4000;0;boundary;;;0;0\n1;Line;0;4000;boundary;;;4000;0\n1;Line;0;0;boundary;;;0;4000\n"
                       "1;Line;4000;1500,0;rock;;;0;1500,0\n1;Point;;;\"fix point\";500;250;;\n",
                       "plan.csv", 1e-3));
}

TEST(ReadCsv, WhatIsWrongIsSaidInOneSentence) {
  const std::vector<std::pair<std::string, std::string>> all{
      {"", "plan.csv is empty, expected a header with layer"},
      {"boundary,0,0,4,0\n", "plan.csv line 1 is \"boundary,0,0,4,0\", expected a header with layer"},
      {"layer,x1,y1,x2,y2\nrock,0,0,4\n", "plan.csv line 2, column y2 is \"\", expected a finite number"},
      {"layer,x1,y1,x2,y2\nrock,0,0,4,inf\n", "plan.csv line 2, column y2 is \"inf\", expected a finite number"},
      {"layer,x1,y1,x2,y2\nrock,0,5,2,75,9,5,7,25\n", "plan.csv line 2 is with 9 cells, expected at most 5"},
      {"layer,x1,y1,x2,y2,y2\nrock,0,0,4,1,2\n", "plan.csv line 1 is with a second column y2, expected each"},
      {"layer,x,y\n,0,0\n", "plan.csv line 2 is without a layer"},
      {"layer,x,y\nrock,,\nrock\n", "plan.csv line 2 is without coordinates"},
  };
  for (const auto& each : all) expect_refused([&] { read_csv_drawing(each.first, "plan.csv", 0); }, each.second);
}

// Found by a mutated file: a joint that ends far away made all lines of the boundary one place, and none was left.
TEST(ReadCsv, ALineFarAwayDoesNotLetOutlinesVanish) {
  const std::string header = "layer,x1,y1,x2,y2\n";
  const auto triangle = [](const std::string& layer) {
    return layer + ",0,0,4,0\n" + layer + ",4,0,0,4\n" + layer + ",0,4,0,0\n";
  };
  const auto plan = [](const std::string& text) {
    return [text] { plan_of(read_csv_drawing(text, "plan.csv", 0), {}); };
  };
  expect_refused(plan(header + triangle("boundary") + "rock,0,1,1e12,1\n"),
                 "plan.csv line 2 (layer boundary) is smaller than 1e+06 m, within which ends belong together");
  expect_refused(
      plan(header + triangle("tunnel") + "boundary,0,1,1e12,1\nboundary,1e12,1,1e12,1e12\nboundary,1e12,1e12,0,1\n"),
      "plan.csv line 2 (layer tunnel) is smaller than");
}

TEST(ReadGeoJson, LinesPolygonsAndPoints) {
  expect_triangle_with_joint(read_geojson(R"({"type": "FeatureCollection", "features": [
    {"type": "Feature", "properties": {"layer": "boundary"},
     "geometry": {"type": "Polygon", "coordinates": [[[0, 0], [4, 0], [0, 4], [0, 0]]]}},
    {"type": "Feature", "properties": {"layer": "rock"}, "geometry": {"type": "GeometryCollection", "geometries": [
      {"type": "MultiLineString", "coordinates": [[[0, 1.5, 7], [4, 1.5]]]}]}},
    {"type": "Feature", "properties": {"layer": "fix point"}, "geometry": {"type": "Point", "coordinates": [0.5, 0.25]}}
  ]})",
                                          "plan.geojson", 0));
}

// RFC 7946, 3.2: a feature may have null for its geometry, and null for its properties.
TEST(ReadGeoJson, FeaturesWithoutAPlaceArePassedOverAndCounted) {
  const LineDrawing drawing = read_geojson(R"({"type": "FeatureCollection", "features": [
    {"type": "Feature", "properties": {"layer": "rock"}, "geometry": null},
    {"type": "Feature", "properties": null, "geometry": null},
    {"type": "Feature", "properties": {"layer": "rock"}, "geometry": {"type": "LineString", "coordinates": [[0, 0], [1, 1]]}}]})",
                                           "plan.geojson", 0);
  EXPECT_EQ(drawing.lines.size(), 1U);
  EXPECT_EQ(drawing.passed_over.at("feature without geometry"), 2);
}

TEST(ReadGeoJson, WhatIsWrongIsSaidInOneSentence) {
  const std::string deep = std::string(40, '[') + std::string(40, ']');
  const auto feature = [](const std::string& rest) {
    return R"({"type": "Feature", "properties": {"layer": "rock"}, )" + rest + "}";
  };
  const std::vector<std::pair<std::string, std::string>> all{
      {"{\n\"type\": ", "plan.geojson line 2 is no JSON, or cut off, expected GeoJSON"},
      {deep, "plan.geojson is nested too deeply"},
      {"[1e999]", "plan.geojson is with a number beyond all bounds, expected GeoJSON with finite numbers"},
      {R"({"type": "FeatureCollection", "crs": {"properties": {"name": "urn:ogc:def:crs:OGC:1.3:CRS84"}}, "features": []})",
       "plan.geojson crs is \"urn:ogc:def:crs:OGC:1.3:CRS84\", degrees, expected coordinates of a plan"},
      {"[]", "plan.geojson is type \"\", expected a FeatureCollection"},
      {R"({"type": "FeatureCollection", "features": [{"type": "Feature"}]})",
       "plan.geojson features[0] is without a layer"},
      {feature(R"("geometry": {})"), "plan.geojson is of geometry \"\""},
      {R"({"type": "Feature", "properties": {"layer": "rock"}})", "plan.geojson is of geometry \"\""},
      {feature(R"("geometry": {"type": "LineString", "coordinates": [[0, 0], [1]]})"),
       "is at a position that is not [x, y]"},
      {feature(R"("geometry": {"type": "LineString", "coordinates": [[0, 0]]})"),
       "is a line of one point on layer \"rock\""},
      {feature(R"("geometry": {"type": "LineString", "coordinates": [[0, 0], [1e300, 0]]})"), "is at (1e+300, 0) m"},
  };
  for (const auto& each : all) expect_refused([&] { read_geojson(each.first, "plan.geojson", 0); }, each.second);
}

}  // namespace
}  // namespace dda
