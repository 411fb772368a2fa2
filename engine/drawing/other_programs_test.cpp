// Drawings that other programs of Debian 12 made, by LibreCAD 2.2.0, FreeCAD 0.20.2, Inkscape 1.2.2 (R14), GDAL 3.6.2,
// pstoedit 3.78, fig2dev 3.2.8b, potrace 1.16, OpenSCAD 2021.01, and dxflib 3.26.4, which is the writer of QCAD.
#include "engine/cutting/cut_rock.h"
#include "engine/drawing/drawing_test_support.h"
#include "engine/drawing/read_drawing.h"

namespace dda {
namespace {

using Roles = std::map<std::string, LayerRole>;

struct Case {
  const char* file;
  double metres;  // a unit of its coordinates; 0: what it says
  Roles layers;
  std::size_t blocks;
  double area;  // m2
};

// Blocks and areas were found without this engine: the entities flattened by ezdxf and divided by the polygonizer of
// GEOS. It leaves out a piece of FreeCAD's ellipse, whose ends are 8e-6 apart, as the parameter has six digits; by hand
// there are two pieces of four, of the ellipse and of the circle each. ezdxf does not read the files of dxflib and
// fig2dev, which were counted by hand.
const std::vector<Case> all{
    {"librecad.dxf", 0, {}, 12, 240e-6},
    {"freecad.dxf", 0, {{"ell", LayerRole::rock}, {"spl", LayerRole::rock}}, 8, 240e-6},
    {"inkscape.dxf", 1, {}, 6, 18000},
    {"gdal.dxf", 1, {}, 6, 240},
    {"gdal.geojson", 1, {}, 6, 240},
    {"pstoedit.dxf",
     1,
     {{"CFF-00-00", LayerRole::boundary}, {"C00-FF-00", LayerRole::tunnel}, {"C00-00-FF", LayerRole::rock}},
     6,
     4.629623703684},
    {"fig2dev.dxf", 1, {{"50", LayerRole::boundary}, {"40", LayerRole::rock}, {"30", LayerRole::tunnel}}, 4, 33.75},
    {"potrace.dxf", 1, {{"0", LayerRole::boundary}}, 1, 153},
    {"openscad.dxf", 1, {{"0", LayerRole::boundary}}, 1, 227.576734444},
    {"dxflib.dxf", 1, {}, 10, 240},
};

TEST(OtherPrograms, DrawingsAreCutAsTheyWereDrawn) {
  for (const Case& each : all) {
    SCOPED_TRACE(each.file);
    DrawingOptions options;
    for (const auto& [layer, role] : each.layers) options.layers[layer].role = role;
    const std::string name = std::string("other_programs/") + each.file;
    const CutRock rock = cut_rock(plan_of(read_drawing(fixture(name), each.file, each.metres), options));
    EXPECT_EQ(rock.blocks.size(), each.blocks);
    double area = 0;
    for (const CutBlock& block : rock.blocks) area += area_moments(block.shape).area;
    EXPECT_NEAR(area, each.area, 1e-9 * each.area);  // digits that the programs write
  }
}

// Inkscape writes the start of a closed curve once more, as a polyline of one point.
TEST(OtherPrograms, PolylinesOfOnePointDrawNothingAndAreCounted) {
  const LineDrawing drawing = read_drawing(fixture("other_programs/inkscape.dxf"), "inkscape.dxf");
  EXPECT_EQ(drawing.passed_over.at("LWPOLYLINE of one point"), 1);
}

// GDAL writes polygons as hatches, unless DXF_WRITE_HATCH is NO.
TEST(OtherPrograms, HatchesArePassedOverAndCounted) {
  const LineDrawing drawing = read_drawing(fixture("other_programs/gdal_hatch.dxf"), "gdal.dxf");
  EXPECT_EQ(drawing.passed_over.at("HATCH"), 1);
  EXPECT_TRUE(plan_of(drawing, {}).boundary.empty());
}

}  // namespace
}  // namespace dda
