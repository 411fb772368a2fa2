// What the tests of this folder share.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include "engine/core/error.h"
#include "engine/core/read_file.h"
#include "engine/drawing/plan_of_drawing.h"

namespace dda {

inline std::string fixture(const std::string& name) { return (std::filesystem::path(DDA_DRAWINGS) / name).string(); }

inline std::string text_of_fixture(const std::string& name) { return read_file(fixture(name)); }

// What the layers of shapes.dxf mean.
inline DrawingOptions shapes_options() {
  DrawingOptions options;
  options.layers["umriss"].role = LayerRole::boundary;
  options.layers["Stollen"].role = LayerRole::tunnel;
  options.layers["FUGEN"] = {LayerRole::rock, "bedding", false};
  return options;
}

// What the tables of the tests mean, whatever program wrote them.
inline void expect_triangle_with_joint(const LineDrawing& drawing) {
  const RockPlan plan = plan_of(drawing, {});
  EXPECT_EQ(std::abs(signed_area(plan.boundary)), 8);
  ASSERT_EQ(plan.lines.size(), 1U);
  EXPECT_EQ(plan.lines[0].points, (std::vector<Vec2>{{0, 1.5}, {4, 1.5}}));
  ASSERT_EQ(plan.points.size(), 1U);
  EXPECT_EQ(plan.points[0].at, Vec2(0.5, 0.25));
}

template <typename Action>
void expect_refused(Action action, const std::string& sentence) {
  try {
    action();
    ADD_FAILURE() << "taken, expected " << sentence;
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find(sentence), std::string::npos) << error.what() << "\nexpected\n"
                                                                           << sentence;
  }
}

}  // namespace dda
