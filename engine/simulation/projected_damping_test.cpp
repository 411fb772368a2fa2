// Dashpots beside projected joints, and beside springs where geometry stays as drawn: they take what a closed form says
// they do, never give, and never pull.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <unsupported/Eigen/MatrixFunctions>

#include "engine/contact/open_close.h"
#include "engine/simulation/projected_models.h"

namespace dda {
namespace {

constexpr double pressure = 2e6;  // Pa, far above what the motion makes

// A block of rock that does not widen (nu = 0) on a held floor, pressed together and pushed off: it bounces on its
// joint, which stays closed, in its centroid's velocity and its own strain.
struct Bouncing {
  double width = 0.8, height = 0.5, ratio = 0.2, joint_stiffness = 0, speed = 1e-3;
  double spring = 0;  // N/m, of either point of a classical joint in place of the projected one
};

Model model_of(const Bouncing& of, double dt, int steps) {
  Model model = on_floor(rectangle("block", 0, 0, of.width, of.height), 0.5,
                         stage_of(generalized_alpha_integrator(0.8), dt, steps));
  model.gravity.setZero();
  model.materials[0].poisson = 0;
  model.joints[0].contact_damping = of.ratio;
  model.joints[0].normal_stiffness = model.joints[0].shear_stiffness = of.joint_stiffness;
  if (of.spring > 0) {
    model.joints[0].law = InterfaceLaw::classical;
    model.joints[0].normal_spring = of.spring;
  }
  for (Block& block : model.blocks) block.initial_stress = {0, -pressure, 0};
  model.edge_loads = {{1, {of.width, of.height}, {0, of.height}, {0, -pressure}, Constant{}}};
  model.blocks[1].initial_velocity = {0, of.speed};
  return model;
}

// M x'' + C x' + K x = 0 of the velocity of the centroid and the strain along y, in their motion from rest; both points
// of the joint move alike, and see the gap g = v - h/2 e + s E e, s E = w/(2 penalty) with the width w = h and the
// penalty 3 (lambda = 1 + nu = 1 in plane stress). Springs see g = v - h/2 e.
struct ClosedForm {
  Eigen::Matrix4d rates;
  Eigen::Matrix2d mass, stiffness;

  explicit ClosedForm(const Bouncing& of) {
    const Material material = rock();
    const double block_mass = material.density * of.width * of.height;
    const double softness = of.spring > 0 ? 0 : of.height / (2 * 3 * material.young);
    const double compliance = softness + (of.joint_stiffness > 0 ? 1 / of.joint_stiffness : 0);
    const double joint = of.spring > 0 ? 2 * of.spring : of.width / compliance;  // both points
    const Eigen::Vector2d gap(1, -of.height / 2 + softness * material.young);
    mass = Eigen::Vector2d(block_mass, block_mass * of.height * of.height / 12).asDiagonal();
    stiffness = joint * gap * gap.transpose();
    stiffness(1, 1) += material.young * of.width * (of.height - softness * material.young);
    const double dashpots = 2 * 2 * of.ratio * std::sqrt(joint / 2 * block_mass);
    rates.setZero();
    rates.topRightCorner<2, 2>().setIdentity();
    rates.bottomLeftCorner<2, 2>() = -mass.inverse() * stiffness;
    rates.bottomRightCorner<2, 2>() = -dashpots * mass.inverse() * gap * gap.transpose();
  }

  // Displacements and velocities at `time` (s), pushed off at the start.
  [[nodiscard]] Eigen::Vector4d at(double time, double speed) const { return (time * rates).exp().col(2) * speed; }
  [[nodiscard]] double energy(const Eigen::Vector4d& x) const {
    return (x.tail<2>().dot(mass * x.tail<2>()) + x.head<2>().dot(stiffness * x.head<2>())) / 2;
  }
};

// Second order in dt: 1e-5 of the transit time of a wave through the block leaves 1e-4 of the amplitude at most.
void expect_closed_form(const Bouncing& of) {
  const double dt = of.height / std::sqrt(rock().young / rock().density) / 200;
  const ClosedForm exact(of);
  Simulation simulation = simulation_of(model_of(of, dt, 2000));
  for (int i = 0; i < 20; ++i) {
    run(simulation, 100);
    const Eigen::Vector4d expected = exact.at(simulation.state().time, of.speed);
    EXPECT_NEAR(simulation.state().velocity[1](1), expected(2), 2e-3 * of.speed);
    EXPECT_LT(std::abs(simulation.energy().relative_residual()), 1e-10);
  }
  const double start = exact.energy({0, 0, of.speed, 0});
  const double lost = start - exact.energy(exact.at(simulation.state().time, of.speed));
  EXPECT_NEAR(simulation.energy().dashpot, lost, 5e-3 * start);
}

TEST(ProjectedDamping, DecaysAsTheClosedForm) {
  expect_closed_form({});
  expect_closed_form({.joint_stiffness = 2e10});
  expect_closed_form({.width = 2, .height = 0.3, .ratio = 0.02});
}

// They did nothing there until the joint had slid or opened: dry springs began as bonded ones.
TEST(SpringDamping, DecaysAsTheClosedFormWhereGeometryStaysAsDrawn) {
  expect_closed_form({.spring = 2e9});
  expect_closed_form({.ratio = 0.02, .spring = 1e11});
}

// A block that bounces undamped comes to rest once its joint has dashpots.
TEST(SpringDamping, BeginsWithTheStageThatGivesIt) {
  Bouncing of{.ratio = 0, .spring = 2e9};
  const double period = 2 * std::numbers::pi / std::sqrt(2 * of.spring / (rock().density * of.width * of.height));
  Model model = model_of(of, period / 100, 200);
  model.stages.push_back(model.stages[0]);
  model.stages[1].rock.joints = model.joints;
  model.stages[1].rock.joints[0].contact_damping = 0.5;
  Simulation simulation = simulation_of(std::move(model));
  run(simulation, 200);
  EXPECT_EQ(simulation.energy().dashpot, 0);
  const double kinetic = simulation.energy().initial.kinetic;
  run(simulation, 200);
  EXPECT_GT(simulation.energy().dashpot, 0.9 * kinetic);
}

// Gaps by lot from step to step: the dashpots of a bed take energy, whatever opens or closes, and never pull.
TEST(ProjectedDamping, TakesEnergyFromAnyMotion) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> share(-1, 1);
  for (int i = 0; i < 20000; ++i) {
    InterfaceSprings springs;
    springs.law = InterfaceLaw::projected;
    springs.length = 1;
    springs.lever = 0.4 + 0.15 * share(random);
    springs.spread = 0.5 + 0.5 * share(random);
    springs.stiffness = Vec4(1, 0.5, 1, 0.5);
    springs.dashpot = std::pow(10, share(random)) * Vec4(1, 0.7, 1, 0.7);
    EndStrength strength;
    strength.friction = 0.5;
    InterfaceState start;
    start.broken = {true, true};
    start.gap = Vec4(share(random), 0, share(random), 0);
    const ContactRule rule{.dashpot_rate = std::pow(10, share(random))};
    InterfaceTrial trial = start_trial(springs, strength, start, rule);
    start = finish_trial(springs, start, trial);  // with the forces of its gaps
    trial = start_trial(springs, strength, start, rule);
    trial.gap += Vec4(share(random), share(random), share(random), share(random));
    respond_with_friction(springs, strength, trial);
    EXPECT_LE(trial.force(0) + trial.force(2), 1e-12);
    const InterfaceState after = finish_trial(springs, start, trial);
    const Vec4 moved = trial.gap - trial.start;
    const Vec2 of_dashpots(trial.force(0) - after.force(0), trial.force(2) - after.force(2));
    EXPECT_GE(of_dashpots.dot(Vec2(moved(0), moved(2))), -1e-12);
    const Vec4 booked = dashpot_force(springs, trial);
    EXPECT_LT((Vec2(booked(0), booked(2)) - of_dashpots).norm(), 1e-12);
  }
}

// A wall that is shaken until bricks slide and lift off, by lot.
Model damped_wall(unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> share(0, 1);
  const Kinematics kinematics = seed % 2 == 0 ? Kinematics::small : Kinematics::finite;
  const Integrator integrator = seed % 3 == 0 ? thesis_integrator() : generalized_alpha_integrator(0.8 * share(random));
  Model model = wall_on_shaken_floor(Vec2(3e-4, 4e-4) * share(random), stage_of(integrator, 2e-4, 200, kinematics));
  model.joints[0].friction_angle = 0.2 + 0.5 * share(random);
  model.joints[0].contact_damping = share(random);
  return model;
}

TEST(ProjectedDamping, LedgersOfDampedWallsBalance) {
  for (unsigned seed = 0; seed < 60; ++seed) {
    Simulation simulation = simulation_of(damped_wall(seed));
    double dashpot = 0;
    // A force that the balance takes for one of later than the middle of its step acts in the motion of the next step
    // too, which may have turned: that gives a little back (measured up to 1.0 % of what dashpots had taken).
    const double turned = simulation.model().stages[0].integrator.name == "thesis" ? 0 : 0.02;
    for (int i = 0; i < 200; ++i) {
      ASSERT_EQ(simulation.step(), Status::ok) << "seed " << seed << ": " << simulation.message();
      ASSERT_LT(std::abs(simulation.energy().relative_residual()), 1e-9) << "seed " << seed << ", step " << i;
      ASSERT_GE(simulation.energy().dashpot, dashpot - turned * dashpot - 1e-9 * simulation.energy().scale())
          << "seed " << seed;
      dashpot = simulation.energy().dashpot;
    }
    EXPECT_GT(dashpot, 0) << "seed " << seed;
  }
}

}  // namespace
}  // namespace dda
