#include "engine/contact/point_kinematics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "engine/contact/contact_set.h"
#include "engine/contact/make_element.h"

namespace dda {
namespace {

// Two blocks that meet along an oblique edge, or at one vertex of it.
InterfaceElement element_of(double length) {
  Model model;
  model.materials.push_back({"rock", 2600, 1e9, 0.2, PlaneState::stress});
  model.joints.emplace_back().law = InterfaceLaw::classical;
  model.joints[0].spring_over_young = 10;
  model.blocks.emplace_back().shape.outer = {{0, 0}, {2, 0}, {1, 3}, {-1, 2}};
  model.blocks.emplace_back().shape.outer = {{2, 0}, {4, 1}, {3, 4}, {1, 3}};
  finish_model(model);
  const Vec2 direction = Vec2(-1, 3).normalized();
  Interface interface;
  interface.block_b = 1;
  interface.from = {2, 0};
  interface.to = interface.from + length * direction;
  interface.normal = {direction.y(), -direction.x()};
  interface.length = length;
  InterfaceElement element = make_element(model, interface, InterfaceLaw::classical);
  set_geometry(model, reference_frame(model, interface), element);
  return element;
}

// As the rows of the element: both are exact but for some roundings of numbers of size 10.
TEST(PointKinematics, IsThatOfTheRows) {
  constexpr double round_off = 1e-13;
  Eigen::VectorXd increments(12);
  increments << 0.3, -0.7, 0.2, 0.5, -0.4, 0.9, -0.1, 0.6, -0.8, 0.15, 0.35, -0.25;
  for (const double length : {0.0, std::sqrt(10.0)}) {
    const InterfaceElement element = element_of(length);
    const PointKinematics points(element);
    const Vec4 gap = points.gap(increments.segment<6>(0), increments.segment<6>(6));
    EXPECT_LT((gap - gap_increment(element, increments)).norm(), round_off);
    EXPECT_NE(gap.head<2>().norm(), 0);
    EXPECT_EQ(gap.tail<2>().isZero(0), length == 0);

    const Vec4 force = length > 0 ? Vec4(2, -3, 0.5, 7) : Vec4(2, -3, 0, 0);
    Eigen::VectorXd expected = Eigen::VectorXd::Ones(12), on = expected;
    add_interface_force(element, force, Vec4::Zero(), expected);
    points.add_force(force, on.segment<6>(0), on.segment<6>(6));
    EXPECT_LT((on - expected).norm(), 100 * round_off);
  }
}

}  // namespace
}  // namespace dda
