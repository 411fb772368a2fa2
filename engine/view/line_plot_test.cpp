#include "engine/view/line_plot.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>

namespace dda {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

bool contains(const std::string& text, const char* part) { return text.find(part) != std::string::npos; }

TEST(LinePlot, PutsValuesWhereTheAxesSay) {
  const std::string svg = svg_plot({"push", "N", {0, 1, 2}, {{"push", {0, 1e6, 0}}}});
  // From the left edge of the axes to the right one, up by what is left of 260 px without margins and headroom.
  EXPECT_TRUE(contains(svg, "d=\"M78 207.7l275 -165.4l275 165.4\"")) << svg;
  EXPECT_TRUE(contains(svg, "push (MN)")) << svg;
  EXPECT_TRUE(contains(svg, "time (s)"));
}

TEST(LinePlot, LeavesGapsWhereThereIsNoNumber) {
  const std::string svg = svg_plot({"a & b", "-", {0, 1, 2, 3, 4}, {{"a", {1, 1, nan, 2, 2}}, {"b", {1, 2, 3, 4, 5}}}});
  EXPECT_TRUE(contains(svg, "a &amp; b"));
  EXPECT_FALSE(contains(svg, "nan"));
  EXPECT_TRUE(contains(svg, "h18"));  // two lines have a key
}

TEST(LinePlot, OfNothingAndOfOneMomentIsAPlot) {
  for (const LinePlot& plot : {LinePlot{}, LinePlot{"one", "m", {5}, {{"one", {3}}}},
                               LinePlot{"none", "m", {0, 1}, {{"none", {nan, nan}}}, true},
                               LinePlot{"zero", "m", {0, 1}, {{"zero", {0, 0}}}, true}}) {
    const std::string svg = svg_plot(plot);
    EXPECT_TRUE(contains(svg, "</svg>"));
    EXPECT_FALSE(contains(svg, "nan") || contains(svg, "inf")) << svg;
  }
}

TEST(LinePlot, ShowsSizesOverPowersOfTen) {
  const std::string svg = svg_plot({"error", "-", {0, 1}, {{"error", {-1e-12, 1e-9}}}, true});
  EXPECT_TRUE(contains(svg, "1e-12") && contains(svg, "1e-9")) << svg;
}

// A power law is a straight line over two axes of powers of ten; measured points are dots that nothing joins.
TEST(LinePlot, ShowsPowersOfTenOnBothAxes) {
  const LinePlot plot{"speed", "m/s", {1, 10, 100}, {{"measured", {10, 1, 0.1}, true}, {"law", {10, 1, 0.1}}},
                      true,    "R",   "m",          true};
  const std::string svg = svg_plot(plot);
  // Two decades on 550 px and on 182 px.
  EXPECT_TRUE(contains(svg, "d=\"M78 34l275 91l275 91\"")) << svg;
  EXPECT_TRUE(contains(svg, "d=\"M78 34l0 0M353 125l0 0M628 216l0 0\"")) << svg;
  EXPECT_TRUE(contains(svg, ">20</text>") && contains(svg, "R (m)")) << svg;
}

}  // namespace
}  // namespace dda
