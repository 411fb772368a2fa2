// Linings: rings in elastic rock against theory, beams between two blocks, what they have to do with stages, motion,
// energy and restarts.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <vector>

#include "engine/simulation/branch.h"
#include "engine/simulation/lining_models.h"
#include "engine/simulation/memory_test_support.h"
#include "engine/simulation/run_so_far.h"

namespace dda {
namespace {

// --- A round hole in elastic rock ---

// The largest differences from theory over the largest of each quantity.
struct RingErrors {
  double thrust = 0, moment = 0;
};

RingErrors errors_of(const Simulation& simulation, const LinedHole& hole) {
  const RingForces exact = ring_in_annulus(hole);
  const double step = 2 * std::numbers::pi / hole.sectors;
  RingErrors errors;
  for (std::size_t i = 0; i < simulation.model().linings[0].elements(); ++i) {
    const double phi = (hole.sectors - 1 - static_cast<int>(i)) * step;
    const SectionForces forces = linings_of(simulation).forces(simulation.model(), 0, i);
    errors.thrust = std::max(errors.thrust, std::abs(forces.thrust - exact.thrust(phi)));
    errors.moment = std::max(errors.moment, std::abs(forces.moment() - exact.moment(phi)));
  }
  errors.thrust /= std::abs(exact.thrust_0) + std::abs(exact.thrust_2);
  errors.moment /= std::abs(exact.moment_2);
  return errors;
}

RingErrors errors_of(const LinedHole& hole) {
  Simulation simulation = simulation_of(lined_hole(hole, bond(InterfaceLaw::consistent)));
  EXPECT_TRUE(simulation.plan().linear);
  run(simulation, 3);
  EXPECT_LT(std::abs(simulation.energy().relative_residual()), 1e-12);
  return errors_of(simulation, hole);
}

// Thrust, a first derivative of what the rock does, converges with the second order, moments, differences of turns that
// blocks have in common with their strains, a little better than the first.
TEST(Lining, CarriesWhatARingInElasticRockDoes) {
  for (const double thickness : {0.05, 0.2, 0.4}) {
    for (const Vec3& far_stress : {Vec3(-2e6, -1e6, 0), Vec3(-1e6, -1e6, 0), Vec3(-0.5e6, -2e6, 0)}) {
      LinedHole hole{.far_stress = far_stress, .thickness = thickness};
      hole.sectors = 16;
      const RingErrors coarse = errors_of(hole);
      hole.sectors = 64;
      const RingErrors fine = errors_of(hole);
      EXPECT_LT(coarse.thrust, 0.04);
      EXPECT_LT(fine.thrust, coarse.thrust / 6);
      if (far_stress(0) == far_stress(1)) continue;  // no moments
      EXPECT_LT(coarse.moment, 0.3);
      EXPECT_LT(fine.moment, coarse.moment / 5);
    }
  }
}

// --- Two blocks far from each other, the left one held, and a lining along their lower sides between them ---

constexpr double span = 2;  // m, from the middle of one side to that of the other

// So stiff that their strains are nothing beside those of the lining.
Model two_blocks(Kinematics kinematics) {
  Model model;
  model.materials = {rock()};
  model.materials[0].young = 1e15;
  model.materials[0].density = 2600;
  model.joints = {strong(InterfaceLaw::classical)};
  model.blocks = {rectangle("left", -0.5, 0, 1, 1), rectangle("right", span - 0.5, 0, 1, 1)};
  model.held_blocks = {HeldBlock{}};
  Lining lining;
  lining.name = "beam";
  lining.nodes = {{0, {0, 0}, {1, 0}}, {1, {span, 0}, {1, 0}}};
  lining.thickness = 0.2;
  lining.young = 15e9;
  lining.poisson = 0.2;
  model.linings = {lining};
  model.stages = {stage_of(static_integrator(), 100, 4, kinematics)};
  return model;
}

LiningSection section_of(const Lining& lining) {
  return lining_section(lining.thickness, lining.young, lining.poisson);
}

SectionForces forces_of(const Simulation& simulation) {
  return linings_of(simulation).forces(simulation.model(), 0, 0);
}

TEST(Lining, IsACantileverBetweenTwoBlocks) {
  constexpr double load = 1e4;
  for (const Kinematics kinematics : {Kinematics::small, Kinematics::finite}) {
    Model model = two_blocks(kinematics);
    model.point_loads = {{1, {span, 0}, {0, load}, Constant{}}};
    Simulation simulation = simulation_of(model);
    run(simulation, 4);
    const LiningSection section = section_of(model.linings[0]);
    const double exact = load * std::pow(span, 3) / (3 * section.bending) + load * span / section.shear;
    const double deflection = point_displacement(simulation.model(), simulation.state(), 1, {span, 0}).y();
    // The tip turns by 1.5e-3: finite kinematics shorten the lever by the square of that.
    EXPECT_NEAR(deflection, exact, 1e-5 * exact);
    EXPECT_NEAR(forces_of(simulation).shear, -load, 1e-5 * load);
    EXPECT_NEAR(forces_of(simulation).moment_at_start, load * span, 1e-5 * load * span);
    EXPECT_NEAR(forces_of(simulation).moment_at_end, 0, 1e-5 * load * span);
    EXPECT_LT(std::abs(simulation.energy().relative_residual()), 1e-9);
  }
}

// --- Motion ---

// Blocks that spin as a whole by two fifths of a rad: what the beam carries is what keeps them together, no more.
TEST(Lining, TurnsWithItsBlocks) {
  Model model = two_blocks(Kinematics::finite);
  model.held_blocks.clear();
  constexpr double spin = 2;  // rad/s
  const Vec2 about(span / 2, 0.5);
  for (Block& block : model.blocks) {
    const Vec2 arm = Vec2(block.name == "left" ? 0 : span, 0.5) - about;
    block.initial_spin = spin;
    block.initial_velocity = spin * Vec2(-arm.y(), arm.x());
  }
  model.stages = {stage_of(generalized_alpha_integrator(1), 1e-4, 2000, Kinematics::finite)};
  Simulation simulation = simulation_of(model);
  run(simulation, 2000);
  // Each block pulls the beam with m omega^2 r, and swings about that on it.
  const double pull = 2600 * spin * spin * span / 2;
  EXPECT_NEAR(simulation.state().displacement[1](2), spin * 0.2, 1e-3);
  EXPECT_LT(std::abs(forces_of(simulation).thrust), 3 * pull);
  EXPECT_LT(std::abs(forces_of(simulation).moment()), 3 * pull) << "the beam lies 0.5 m off the centres";
  EXPECT_LT(std::abs(simulation.energy().relative_residual()), 1e-9);
}

TEST(Lining, KeepsTheLedgerInEveryIntegratorAndKind) {
  LinedHole hole{.outer_radius = 5, .sectors = 12};
  for (const auto& joint : {bond(InterfaceLaw::consistent), strong(InterfaceLaw::classical)}) {
    for (const Kinematics kinematics : {Kinematics::small, Kinematics::finite}) {
      for (const Integrator& integrator : dynamic_integrators()) {
        Model model = lined_hole(hole, joint);
        model.stages = {stage_of(integrator, 2e-5, 60, kinematics)};
        for (const double strength : {std::numeric_limits<double>::infinity(), 1e6}) {
          model.linings[0].compressive_strength = strength;
          model.linings[0].tensile_strength = strength / 10;
          Simulation simulation = simulation_of(model);
          run(simulation, 60);
          EXPECT_GT(simulation.energy().linings, 0);
          EXPECT_EQ(simulation.energy().plastic > 0, strength == 1e6);
          EXPECT_LT(std::abs(simulation.energy().relative_residual()), 1e-10) << integrator.name;
        }
      }
    }
  }
}

// The general step and the linear one are two ways to the same.
TEST(Lining, IsTheSameInGeneralSteps) {
  LinedHole hole{.outer_radius = 5, .sectors = 16};
  const auto forces = [&](const JointMaterial& joint) {
    Model model = lined_hole(hole, joint);
    model.stages = {stage_of(generalized_alpha_integrator(0.8), 5e-5, 40)};
    Simulation simulation = simulation_of(model);
    EXPECT_EQ(simulation.plan().linear, joint.bonded);
    run(simulation, 40);
    return linings_of(simulation).forces(simulation.model(), 0, 3);
  };
  const SectionForces linear = forces(bond(InterfaceLaw::consistent));
  const SectionForces general = forces(strong(InterfaceLaw::consistent));
  EXPECT_NEAR(linear.thrust, general.thrust, 1e-9 * std::abs(linear.thrust));
  EXPECT_NEAR(linear.moment(), general.moment(), 1e-9 * std::abs(linear.moment()));
}

// --- Stages ---

// Half of the load comes before it is sprayed, half after: it carries what it does under that half alone.
TEST(Lining, TakesNoneOfWhatCameBefore) {
  LinedHole hole{.outer_radius = 5, .sectors = 16};
  for (const bool bonded : {true, false}) {
    const JointMaterial joint = bonded ? bond(InterfaceLaw::consistent) : strong(InterfaceLaw::consistent);
    Simulation early = simulation_of(lined_hole(hole, joint));
    run(early, 3);
    Model model = lined_hole(hole, joint);
    for (EdgeLoad& load : model.edge_loads) load.history = PiecewiseLinear{{0, 30, 40}, {1, 1, 2}};
    model.stages.push_back(model.stages[0]);
    model.linings[0].first_stage = 1;
    Simulation late = simulation_of(model);
    run(late, 3);
    EXPECT_EQ(late.energy().linings, 0);
    EXPECT_EQ(linings_of(late).forces(model, 0, 2).thrust, 0);
    run(late, 3);
    for (std::size_t i = 0; i < model.linings[0].elements(); ++i) {
      const SectionForces expected = linings_of(early).forces(model, 0, i);
      const SectionForces forces = linings_of(late).forces(model, 0, i);
      EXPECT_NEAR(forces.thrust, expected.thrust, 1e-6 * std::abs(expected.thrust));
      EXPECT_NEAR(forces.moment(), expected.moment(), 1e-6 * std::abs(expected.thrust));
    }
    EXPECT_LT(std::abs(late.energy().relative_residual()), 1e-10);
  }
}

// --- Yield ---

TEST(Lining, CrushesAtItsStrength) {
  Model model = two_blocks(Kinematics::finite);
  model.linings[0].compressive_strength = 20e6;
  model.linings[0].tensile_strength = 2e6;
  // The right block is moved: to press the beam, to pull it; and both are turned about its ends.
  model.held_blocks.emplace_back().block = 1;
  const auto after = [&](const Vec2& moved, double turn) {
    for (HeldBlock& held : model.held_blocks) held.history = PiecewiseLinear{{0, 400}, {0, 1}};
    model.held_blocks[0].turn = -turn;
    model.held_blocks[1].amplitude = moved;
    model.held_blocks[1].turn = turn;
    model.held_blocks[1].about = {span, 0};
    Simulation simulation = simulation_of(model);
    run(simulation, 4);
    EXPECT_LT(std::abs(simulation.energy().relative_residual()), 1e-12);
    EXPECT_GT(simulation.energy().plastic, 0);
    EXPECT_TRUE(linings_of(simulation).element(0, 0).has_yielded());
    EXPECT_NEAR(forces_of(simulation).utilisation, 1, 1e-9);
    return forces_of(simulation);
  };
  EXPECT_NEAR(after({-0.02, 0}, 0).thrust, 20e6 * 0.2, 1e-3);
  EXPECT_NEAR(after({0.02, 0}, 0).thrust, -2e6 * 0.2, 1e-3);
  // Held at its length it is pressed until its thrust is that of the largest moment, half of the difference of both
  // strengths: (f_c + f_t) h^2/8.
  const SectionForces bent = after({0, 0}, 0.25);
  EXPECT_NEAR(bent.moment(), 22e6 * 0.2 * 0.2 / 8, 0.01 * bent.moment());
  EXPECT_NEAR(bent.thrust, 9e6 * 0.2, 0.1 * bent.thrust);
  EXPECT_NEAR(bent.shear, 0, 1e-3);
}

// The ring of a crushing lining presses on the rock with f_c h/r wherever it is.
TEST(Lining, CrushesAllAroundUnderPressureFromAllSides) {
  LinedHole hole{.outer_radius = 6, .sectors = 24, .far_stress = {-10e6, -10e6, 0}};
  Model model = lined_hole(hole, bond(InterfaceLaw::consistent));
  model.linings[0].compressive_strength = 10e6;
  model.linings[0].tensile_strength = 1e6;
  Simulation simulation = simulation_of(model);
  EXPECT_FALSE(simulation.plan().linear);
  run(simulation, 3);
  for (std::size_t i = 0; i < model.linings[0].elements(); ++i)
    EXPECT_NEAR(linings_of(simulation).forces(model, 0, i).thrust, 10e6 * hole.thickness, 1e-5 * 10e6 * hole.thickness)
        << "up to the moments of a polygon";
  EXPECT_LT(std::abs(simulation.energy().relative_residual()), 1e-10);
}

// --- Restarts and branches ---

Model late_lining(bool yields, const JointMaterial& joint, Kinematics kinematics) {
  LinedHole hole{.outer_radius = 5, .sectors = 10};
  Model model = lined_hole(hole, joint);
  if (yields) model.linings[0].compressive_strength = 1e6;
  if (yields) model.linings[0].tensile_strength = 1e5;
  model.linings[0].first_stage = 1;
  model.stages.assign(2, stage_of(generalized_alpha_integrator(0.8), 5e-5, 20, kinematics));
  finish_model(model);
  return model;
}

// A static stage with a lining that yielded all around factorized the same matrix a thousand times a step.
TEST(Lining, KeepsItsSlopesFromOneElasticRoundToTheNext) {
  Model weak = two_blocks(Kinematics::small);
  weak.linings[0].compressive_strength = 1e3;
  weak.linings[0].tensile_strength = 1e2;
  const Model model = simulation_of(weak).model();
  LiningSet linings(model, initial_state(model));
  linings.begin_step();
  Eigen::VectorXd apart = Eigen::VectorXd::Zero(12);
  apart(6) = 0.01;
  constexpr int quick = 0, sure = 50;
  EXPECT_TRUE(linings.follow(apart, quick).has_other_slopes);
  EXPECT_TRUE(linings.follow(apart, sure).has_other_slopes);
  apart(6) = 0.02;
  const LiningRound next = linings.follow(apart, sure);
  EXPECT_TRUE(next.goes_on);
  EXPECT_FALSE(next.has_other_slopes);
}

TEST(Lining, RestartsAndBranchesToTheBit) {
  for (const Kinematics kinematics : {Kinematics::small, Kinematics::finite})
    for (const auto& [yields, joint] :
         {std::pair{false, bond(InterfaceLaw::consistent)}, std::pair{true, strong(InterfaceLaw::classical)},
          std::pair{true, bond(InterfaceLaw::consistent)}, std::pair{true, bond(InterfaceLaw::classical)}}) {
      const Model model = late_lining(yields, joint, kinematics);
      for (const int stop : {10, 27}) {
        Simulation whole(model);
        run(whole, stop);
        Simulation resumed(model);
        restore(resumed, whole.state(), save(whole));
        run(whole, 40 - stop);
        run(resumed, 40 - stop);
        ASSERT_EQ(memory_of(whole), memory_of(resumed)) << yields << ", from step " << stop;
        EXPECT_EQ(linings_of(whole).element(0, 0).has_yielded(), yields);
      }
      Model without = model;
      without.linings.clear();
      without.stages.resize(1);
      Simulation settled(without);
      run(settled, 20);
      Simulation branch(model);
      begin_from(settled, branch);
      Simulation whole(model);
      run(whole, 20);
      run(whole, 20);
      run(branch, 20);
      for (std::size_t i = 0; i < model.linings[0].elements(); ++i)
        EXPECT_EQ(linings_of(whole).element(0, i).gap, linings_of(branch).element(0, i).gap);
    }
}

}  // namespace
}  // namespace dda
