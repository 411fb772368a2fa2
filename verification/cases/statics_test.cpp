// Catalogue 24-26: uniaxial compression, stiffness of a stack, a column under its own weight.
#include <gtest/gtest.h>

#include <cmath>

#include "dda/simulation/simulation.h"
#include "verification/cases/bar_case.h"
#include "verification/exact/wave_speeds.h"

namespace verify {
namespace {

using dda::InterfaceLaw;
using dda::Vec2;

constexpr double young = 5e9;
constexpr double density = 2600;

// A column of blocks 1 m wide that stands on y = 0.
dda::Model column(int blocks, double height, InterfaceLaw law, const dda::Material& rock) {
  dda::Model model;
  model.materials = {rock};
  dda::JointMaterial joint;
  joint.law = law;
  joint.bonded = true;
  model.joints = {joint};
  for (int i = 0; i < blocks; ++i) {
    const double bottom = height * i / blocks;
    const double top = height * (i + 1) / blocks;
    model.blocks.emplace_back().shape.outer = {{0, bottom}, {1, bottom}, {1, top}, {0, top}};
  }
  dda::Stage stage;
  stage.integrator = dda::static_integrator();
  stage.kinematics = dda::Kinematics::small;
  stage.dt = 10;  // inertia is then 1e-8 of the stiffness: what a static step leaves out of balance
  stage.duration = 40 * stage.dt;
  stage.solver = dda::SolverRequest::cholesky;
  model.stages = {stage};
  return model;
}

struct Settled {
  dda::Model model;
  dda::State state;
};

Settled settle(dda::Model model) {
  dda::finish_model(model);
  dda::Simulation simulation(model);
  while (!simulation.finished()) {
    if (simulation.step() != dda::Status::ok) ADD_FAILURE() << simulation.message();
  }
  EXPECT_LT(simulation.out_of_balance(), 1e-9);
  return {model, simulation.state()};
}

// Compressed between two loads of 1 MPa, held nowhere.
dda::Model compressed(int blocks, double height, InterfaceLaw law, const dda::Material& rock) {
  dda::Model model = column(blocks, height, law, rock);
  model.edge_loads = {{blocks - 1, {1, height}, {0, height}, {0, -1e6}, {}}, {0, {0, 0}, {1, 0}, {0, 1e6}, {}}};
  return model;
}

// Statics to 1e-9 (out of balance) and a solve of condition 1e4.
constexpr double static_error = 1e-8;

class Catalogue24 : public testing::TestWithParam<InterfaceLaw> {};
INSTANTIATE_TEST_SUITE_P(UniaxialCompression, Catalogue24,
                         testing::Values(InterfaceLaw::classical, InterfaceLaw::consistent, InterfaceLaw::cubic),
                         [](const auto& law) {
                           return law.param == InterfaceLaw::classical    ? "classical"
                                  : law.param == InterfaceLaw::consistent ? "consistent"
                                                                          : "cubic";
                         });

TEST_P(Catalogue24, LateralRatio) {
  for (const double poisson : {0.1, 0.25, 0.4}) {
    for (const dda::PlaneState plane : {dda::PlaneState::stress, dda::PlaneState::strain}) {
      const double expected = plane == dda::PlaneState::stress ? exact::lateral_ratio_plane_stress(poisson)
                                                               : exact::lateral_ratio_plane_strain(poisson);
      for (const int blocks : {1, 4}) {
        const Settled settled = settle(compressed(blocks, 4, GetParam(), {"rock", density, young, poisson, plane}));
        for (std::size_t i = 0; i < settled.state.stress.size(); ++i) {
          const dda::Vec6& strain = settled.state.displacement[i];
          EXPECT_NEAR(-strain(3) / strain(4), expected, static_error);
          EXPECT_NEAR(settled.state.stress[i](1), -1e6, static_error * 1e6);
          EXPECT_NEAR(settled.state.stress[i](0), 0, static_error * 1e6);
        }
      }
    }
  }
}

double shortening(const Settled& settled, double height) {
  const int last = static_cast<int>(settled.model.blocks.size()) - 1;
  return dda::point_displacement(settled.model, settled.state, 0, {0.5, 0}).y() -
         dda::point_displacement(settled.model, settled.state, last, {0.5, height}).y();
}

TEST(Catalogue25, StackStiffness) {
  constexpr double height = 6;
  for (const double spring : {1.0, 10.0, 100.0}) {
    for (const int blocks : {1, 2, 6, 12}) {
      dda::Model model =
          compressed(blocks, height, InterfaceLaw::classical, {"rock", density, young, 0.25, dda::PlaneState::stress});
      model.joints[0].spring_over_young = spring;
      const double modulus = 1e6 * height / shortening(settle(std::move(model)), height);
      const double expected = exact::stack_modulus(young, height / blocks, 1, 2 * spring * young, blocks);
      EXPECT_NEAR(modulus, expected, static_error * expected) << blocks << " blocks, springs of " << spring << " E";
    }
  }
}

TEST(Catalogue25, StackOfConsistentAndCubicJointsIsAsStiffAsRock) {
  for (const InterfaceLaw law : {InterfaceLaw::consistent, InterfaceLaw::cubic}) {
    const Settled settled = settle(compressed(6, 6, law, {"rock", density, young, 0.25, dda::PlaneState::stress}));
    EXPECT_NEAR(1e6 * 6 / shortening(settled, 6), young, static_error * young);
  }
}

constexpr double column_height = 8;
constexpr double base_stiffness = 4e12;  // N/m, both corners together

dda::Model standing(int blocks, InterfaceLaw law, double poisson) {
  dda::Model model = column(blocks, column_height, law, {"rock", density, young, poisson, dda::PlaneState::stress});
  model.gravity = {0, -9.81};
  model.supports = {{0, {0, 0}, false, true, base_stiffness / 2, Vec2::Zero(), {}},
                    {0, {1, 0}, false, true, base_stiffness / 2, Vec2::Zero(), {}},
                    {0, {0.5, 0}, true, false, base_stiffness, Vec2::Zero(), {}}};
  return model;
}

double top_settlement(const Settled& settled) {
  const int last = static_cast<int>(settled.model.blocks.size()) - 1;
  return -dda::point_displacement(settled.model, settled.state, last, {0.5, column_height}).y();
}

TEST(Catalogue26, SelfWeightColumnStressAtCentroids) {
  for (const InterfaceLaw law : {InterfaceLaw::classical, InterfaceLaw::consistent}) {
    for (const double poisson : {0.0, 0.25}) {
      const Settled settled = settle(standing(8, law, poisson));
      for (std::size_t i = 0; i < 8; ++i) {
        const double y = settled.model.blocks[i].moments.centroid.y();
        const double weight = exact::self_weight_pressure(density, 9.81, column_height, 0);
        // A classical block's stress is the mean of the forces on its ends: exact. With Nitsche's method and lateral
        // contraction the jumps of the lateral strain leave gaps of their own, below a hundredth of a block's weight.
        const bool exactly = law == InterfaceLaw::classical || poisson == 0;
        EXPECT_NEAR(-settled.state.stress[i](1), exact::self_weight_pressure(density, 9.81, column_height, y),
                    (exactly ? static_error : 0.01 / 8) * weight)
            << "law " << static_cast<int>(law) << ", block " << i;
      }
    }
  }
}

// The outer halves of the end blocks are straight lines: the stress of the end blocks is off by a fifth of a block's
// weight (measured 0.2023), and the error dies out from block to block.
TEST(Catalogue26, SelfWeightColumnOfCubicJointsIsOffAtItsEndsAlone) {
  const Settled settled = settle(standing(12, InterfaceLaw::cubic, 0.25));
  const double block_weight = exact::self_weight_pressure(density, 9.81, column_height, 0) / 12;
  double previous = 0;
  for (std::size_t i = 0; i < 6; ++i) {
    const double y = settled.model.blocks[i].moments.centroid.y();
    const double error =
        std::abs(settled.state.stress[i](1) + exact::self_weight_pressure(density, 9.81, column_height, y));
    EXPECT_LT(error, i == 0 ? 0.21 * block_weight : 0.2 * previous) << "block " << i;
    previous = error;
  }
}

TEST(Catalogue26, SelfWeightColumnTopSettlement) {
  for (const int blocks : {1, 4, 8, 16}) {
    const double length = column_height / blocks;
    const double classical = exact::block_column_shortening(young, density, 9.81, length, 1, blocks, 20 * young, false);
    const double continuum = exact::self_weight_shortening(young, density, 9.81, column_height);
    const double base = density * 9.81 * column_height / base_stiffness;
    EXPECT_NEAR(top_settlement(settle(standing(blocks, InterfaceLaw::classical, 0))), classical + base,
                static_error * continuum);
    // Blocks that carry the exact stress at their centroids shorten exactly, and consistent joints have no gap.
    EXPECT_NEAR(top_settlement(settle(standing(blocks, InterfaceLaw::consistent, 0))), continuum + base,
                static_error * continuum);
  }
}

// Largest error of the displacement, against rho g (H y - y^2/2)/E of the continuum on its sprung base, at the middles
// and ends of the blocks.
double displacement_error(int blocks) {
  const Settled settled = settle(standing(blocks, InterfaceLaw::consistent, 0));
  double worst = 0;
  for (int i = 0; i < blocks; ++i) {
    for (const double part : {0.0, 0.5, 1.0}) {
      const double y = column_height * (i + part) / blocks;
      const double expected =
          density * 9.81 * ((column_height * y - y * y / 2) / young + column_height / base_stiffness);
      const double actual = -dda::point_displacement(settled.model, settled.state, i, {0.5, y}).y();
      worst = std::max(worst, std::abs(actual - expected));
    }
  }
  return worst;
}

TEST(Catalogue26, SelfWeightColumnDisplacementOrder) {
  const double coarse = displacement_error(8);
  const double fine = displacement_error(16);
  // A straight line through a parabola: rho g L^2/(8 E) off at the middle, and nothing else.
  EXPECT_NEAR(order(coarse, fine), 2, 1e-3);
  EXPECT_NEAR(fine, density * 9.81 * 0.25 / (8 * young), 1e-3 * fine);
}

}  // namespace
}  // namespace verify
