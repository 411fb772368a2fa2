#include "engine/view/svg_path.h"

#include <gtest/gtest.h>

#include <limits>

namespace dda {
namespace {

TEST(SvgPath, StepsAreInTenths) {
  SvgPath path;
  path.move_to({1.04, -2});
  path.line_to({1.26, 0});
  path.close();
  EXPECT_EQ(path.text(), "M1 -2l0.3 2Z");
}

// 10 times the smallest long has no magnitude among longs: this ended the program.
TEST(SvgPath, PointsBeyondAllPicturesCanBeWritten) {
  SvgPath path;
  path.move_to({-1e150, std::numeric_limits<double>::quiet_NaN()});
  path.line_to({1e150, std::numeric_limits<double>::infinity()});
  EXPECT_EQ(path.text(), "M-100000000000000 0l200000000000000 100000000000000");
}

}  // namespace
}  // namespace dda
