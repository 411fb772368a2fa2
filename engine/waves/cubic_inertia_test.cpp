// The inertia of cubic chains against the cubic itself.
#include "engine/waves/cubic_inertia.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/contact/cubic_pair_models.h"
#include "engine/terms/potential_check.h"

namespace dda {
namespace {

using namespace cubic_pair;

constexpr double round_off = 1e-11;  // some hundred products, and differences that lose two digits

double axial_kinetic(const Hermite& cubic, double density) {
  const auto straight = [&](const AxialMotion& block, double t) {
    return block.displacement + t * length * block.strain;
  };
  const auto excess = [&](const AxialMotion& block, double from_centroid, double t) {
    return (std::pow(cubic.value(t), 2) - std::pow(straight(block, from_centroid), 2)) / 2;
  };
  return density * width *
         (half_cell(0, [&](double t) { return excess(cubic.a, t, t); }) +
          half_cell(0.5, [&](double t) { return excess(cubic.b, t - 1, t); }));
}

TEST(CubicInertia, InertiaIsTheHessianOfTheCubicsKineticEnergy) {
  for (const double angle : angles) {
    const Model model = pair_of(materials()[0], angle);
    const InterfaceMatrices m = cubic_inertia(model, find_interfaces(model).at(0), 0, 0.1);
    const auto energy = [&](const Vec12& v) { return axial_kinetic(hermite(v, angle), 2.3); };
    EXPECT_LT(relative_difference(joined(m), hessian<12>(energy, 1)), round_off);
  }
}

TEST(CubicInertia, CorrectionLowersTheInertiaOfRelativeMotionUpToALimit) {
  const Model model = pair_of(materials()[0], 0.4);
  const Interface interface = find_interfaces(model).at(0);
  const double mass = 2.3 * length * width;
  const double courant = std::sqrt(5.0 / 2.3) * 0.1 / length;
  for (const auto& [error, expected] : {std::pair(0.2, 0.2 * courant * courant), std::pair(1e3, 0.1)}) {
    const InterfaceMatrices plain = cubic_inertia(model, interface, 0, 0.1);
    const InterfaceMatrices lowered = cubic_inertia(model, interface, error, 0.1);
    Vec12 apart = some_motion(1);
    const AxialMotion a(apart.head<6>(), 0.4), b(apart.tail<6>(), 0.4);
    const double relative = b.displacement - a.displacement;
    const double jump = length * (b.strain - a.strain);
    const Mat12 difference = joined(plain) - joined(lowered);
    const double of_jump = std::min(expected, 0.05) * jump * jump / 12;
    EXPECT_NEAR(apart.dot(difference * apart) / 2, mass / 2 * (expected * relative * relative + of_jump), round_off);
  }
}

TEST(CubicInertia, LateralInertiaIsTheKineticEnergyOfSidewaysStrain) {
  const double angle = 0.4;
  const Model model = pair_of(materials()[0], angle);
  const double mass = 2.3 * length * width;
  const Mat6 lateral = lateral_inertia(mass, model.blocks[0].moments, find_interfaces(model).at(0).normal);
  // A strip of this width with velocity y e: m width^2/12 e^2/2.
  const auto energy = [&](const Vec6& v) {
    return mass * width * width / 24 * std::pow(AxialMotion(v, angle).lateral, 2);
  };
  EXPECT_LT(relative_difference(lateral, hessian<6>(energy, 1)), round_off);
}

}  // namespace
}  // namespace dda
