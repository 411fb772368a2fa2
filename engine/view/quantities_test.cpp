#include "engine/view/quantities.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

#include "engine/core/error.h"
#include "engine/view/view_test_support.h"

namespace dda {
namespace {

double value_of(std::string_view id, const Frame& frame) {
  return drawn_quantities[find_quantity(id, "--quantity")].value(frame, 0);
}

TEST(DrawnQuantities, AreThoseOfTheStressTensor) {
  for (const Vec3& stress : {Vec3(3, -1, 1.5), Vec3(0, 0, -7), Vec3(-5, -5, 0), Vec3(-2, 4, 0.1)}) {
    Frame frame;
    frame.stress = {stress};
    const Mat2 tensor = (Mat2() << stress[0], stress[2], stress[2], stress[1]).finished();
    const Eigen::SelfAdjointEigenSolver<Mat2> eigen(tensor);
    const double round_off = 1e-14 * 10;
    EXPECT_NEAR(value_of("stress_1", frame), eigen.eigenvalues()(1), round_off);
    EXPECT_NEAR(value_of("stress_2", frame), eigen.eigenvalues()(0), round_off);
    EXPECT_NEAR(value_of("max_shear", frame), (eigen.eigenvalues()(1) - eigen.eigenvalues()(0)) / 2, round_off);
    EXPECT_NEAR(value_of("mean_stress", frame), tensor.trace() / 2, round_off);
    EXPECT_EQ(value_of("stress_xx", frame), stress[0]);
    EXPECT_EQ(value_of("stress_yy", frame), stress[1]);
    EXPECT_EQ(value_of("stress_xy", frame), stress[2]);
    const PrincipalStress principal = principal_stress(stress);
    EXPECT_LE((tensor * principal.direction - principal.first * principal.direction).norm(), round_off);
  }
}

TEST(DrawnQuantities, OfMotionAreSizes) {
  Frame frame;
  frame.velocity = {Vec2(-3, 4)};
  frame.moved = {Vec2(0, -2)};
  EXPECT_EQ(value_of("speed", frame), 5);
  EXPECT_EQ(value_of("displacement", frame), 2);
}

TEST(DrawnQuantities, UnknownOnesAreRefused) {
  const std::string message = message_of<InputError>([] { find_quantity("colour", "--quantity"); });
  EXPECT_EQ(message,
            "--quantity is \"colour\", expected one of mean_stress, stress_1, stress_2, max_shear, stress_xx, "
            "stress_yy, stress_xy, speed, displacement");
}

}  // namespace
}  // namespace dda
