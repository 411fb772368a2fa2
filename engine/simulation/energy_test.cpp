// The energy balance of every combination of integrator, law and feature, and that it reacts to what is wrong.
#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <cmath>
#include <functional>
#include <string>

#include "engine/simulation/energy_audit.h"
#include "engine/simulation/kinematic_update.h"
#include "engine/simulation/simulation_models.h"
#include "engine/terms/viscous_boundary.h"

namespace dda {
namespace {

struct Feature {
  const char* name;
  std::function<void(Model&)> add;
};

void push(Model& model) { model.edge_loads = {{0, {0, 0.8}, {0, 0}, {3e5, 1e5}, SineCycles{60, 1.5, 0}}}; }
void pull_from_the_start(Model& model) { model.point_loads = {{1, {1.2, 0.1}, {2e5, -3e5}, Constant{}}}; }
void add_weight(Model& model) { model.gravity = {3, -9.81}; }
void hold(Model& model) {
  model.supports = {{3, {4, 0}, true, true, 2e9, Vec2::Zero(), {}}, {3, {4, 0.8}, true, false, 1e9, Vec2::Zero(), {}}};
}
void shake(Model& model) {
  model.supports = {{3, {4, 0}, true, true, 2e9, {1e-4, 2e-4}, SineCycles{80, 2, 1e-3}},
                    {0, {0, 0}, false, true, 1e9, {0, 5e-5}, PiecewiseLinear{{0, 0.02}, {0.5, 1}}}};
}
void absorb(Model& model) { model.viscous_edges = {{3, {4, 0}, {4, 0.8}, 1.6e6, 1e6}, {3, {3, 0}, {4, 0}, 5e5, 7e5}}; }
void spin(Model& model) {
  model.blocks[0].initial_velocity = {0.2, -0.1};
  model.blocks[2].initial_spin = 0.2;
}
void prestress(Model& model) {
  for (Block& block : model.blocks) block.initial_stress = {-2e5, -1e5, 3e4};
}
void damp_per_step(Model& model) { model.stages[0].velocity_factor = 0.97; }
void damp_per_time(Model& model) { model.stages[0].damping_rate = 12; }
void damp_material(Model& model) {
  if (!model.stays_linear()) return;
  model.stages[0].material_damping.mass = 20;
  model.stages[0].material_damping.stiffness = 1e-4;
}
void weigh_strains(Model& model) { model.stages[0].strain_inertia = 2; }
void correct_dispersion(Model& model) {
  model.stages[0].correct_block_dispersion = model.stages[0].correct_time_dispersion = true;
}

std::vector<Feature> features() {
  const std::vector<std::function<void(Model&)>> all = {
      push,          pull_from_the_start, add_weight,        shake, absorb, spin, prestress, damp_per_step,
      damp_per_time, weigh_strains,       correct_dispersion};
  const auto with_push = [](const std::function<void(Model&)>& other) {
    return [other](Model& model) {
      push(model);
      other(model);
    };
  };
  return {{"push", push},
          {"constant_load", pull_from_the_start},
          {"gravity", with_push(add_weight)},
          {"support", with_push(hold)},
          {"moving_support", with_push(shake)},
          {"dashpot", with_push(absorb)},
          {"initial_motion", spin},
          {"initial_stress", with_push(prestress)},
          {"k01", with_push(damp_per_step)},
          {"damping_rate", with_push(damp_per_time)},
          {"rayleigh_damping", with_push(damp_material)},
          {"strain_inertia", with_push(weigh_strains)},
          {"corrected", with_push(correct_dispersion)},
          {"everything", [all](Model& model) {
             for (const auto& add : all) add(model);
           }}};
}

std::vector<Integrator> all_integrators() {
  std::vector<Integrator> integrators = dynamic_integrators();
  integrators.push_back(static_integrator());
  return integrators;
}

struct Scene {
  std::string name;
  JointMaterial joint;
  Kinematics kinematics;
  double tolerance;  // of the residual, relative to the largest term of the ledger
};

// Sixty steps, each with a solve of condition 1e3 and a few hundred products. Finite kinematics balance forces in the
// geometry of the step's start, and what following it changes is booked.
std::vector<Scene> scenes() {
  constexpr double round_off = 1e-11;
  constexpr auto small = Kinematics::small;
  return {{"classical_linear", bond(InterfaceLaw::classical), small, round_off},
          {"consistent_linear", bond(InterfaceLaw::consistent), small, round_off},
          {"cubic_linear", bond(InterfaceLaw::cubic), small, round_off},
          {"classical_judged", strong(InterfaceLaw::classical), small, round_off},
          {"consistent_judged", strong(InterfaceLaw::consistent), small, round_off},
          {"classical_finite", bond(InterfaceLaw::classical), Kinematics::finite, round_off},
          {"consistent_finite", bond(InterfaceLaw::consistent), Kinematics::finite, round_off}};
}

Model scene_with(const Scene& scene, const Integrator& integrator, const Feature& feature) {
  Model model = bar_of(4, scene.joint);
  model.stages = {stage_of(integrator, 4e-4, 60, scene.kinematics)};
  feature.add(model);
  return model;
}

class EnergyBalance : public testing::TestWithParam<Scene> {};
INSTANTIATE_TEST_SUITE_P(Simulation, EnergyBalance, testing::ValuesIn(scenes()),
                         [](const auto& each) { return each.param.name; });

TEST_P(EnergyBalance, ResidualIsRoundOff) {
  for (const Integrator& integrator : all_integrators()) {
    for (const Feature& feature : features()) {
      Simulation simulation = simulation_of(scene_with(GetParam(), integrator, feature));
      EXPECT_EQ(simulation.plan().linear, GetParam().name.ends_with("linear"));
      double worst = 0;
      for (int i = 0; i < 60; ++i) {
        ASSERT_EQ(simulation.step(), Status::ok) << simulation.message();
        worst = std::max(worst, std::abs(simulation.energy().relative_residual()));
      }
      EXPECT_LT(worst, GetParam().tolerance) << integrator.name << " with " << feature.name;
      const bool at_rest = integrator.is_static && std::string(feature.name) == "initial_motion";
      EXPECT_EQ(simulation.energy().scale() > 0, !at_rest) << integrator.name << " with " << feature.name;
    }
  }
}

// Stages that change inertia, stiffness and steps while all is in motion.
TEST(EnergyLedger, IsWholeOverStagesWithOtherCorrections) {
  for (const InterfaceLaw law : {InterfaceLaw::consistent, InterfaceLaw::cubic}) {
    Model model = law == InterfaceLaw::cubic ? bar_of(6, bond(law)) : grid_of(4, bond(law));
    spin(model);
    model.stages.clear();
    for (const auto& [dt, corrected] : {std::pair(2e-4, true), {1e-4, true}, {1e-4, false}, {4e-4, true}}) {
      Stage stage = stage_of(generalized_alpha_integrator(0.9), dt, 20);
      stage.correct_block_dispersion = stage.correct_time_dispersion = corrected;
      model.stages.push_back(stage);
    }
    Simulation simulation = simulation_of(std::move(model));
    double worst = 0;
    for (int i = 0; i < 80; ++i) {
      run(simulation, 1);
      worst = std::max(worst, std::abs(simulation.energy().relative_residual()));
    }
    EXPECT_LT(worst, 1e-11);  // round-off, as within a stage
    EXPECT_GT(simulation.energy().kinetic, 0);
  }
}

// The equations are linear, so the balance is as good for motions of 1e-11 m as for those of 1e-3 m, however stiff the
// springs are that hand them on. As above, and three digits more that springs of 1000 E take of a solve.
TEST(EnergyLedger, IsWholeInWeakWavesFromMovedEdges) {
  for (const double size : {1e-11, 1e-3})
    for (const MotionKind kind : {MotionKind::displacement, MotionKind::velocity, MotionKind::acceleration}) {
      Model model = bar_of(20, bond(InterfaceLaw::consistent));
      for (const double y : {0.0, 0.8}) {
        PointSupport support{0, {0, y}, true, false, 1000 * model.materials[0].young, {size, 0}, SineCycles{80, 2, 0}};
        support.kind = kind;
        model.supports.push_back(support);
      }
      model.stages = {stage_of(generalized_alpha_integrator(0.85), 4e-4, 100)};
      Simulation simulation = simulation_of(std::move(model));
      double worst = 0;
      for (int i = 0; i < 100; ++i) {
        run(simulation, 1);
        worst = std::max(worst, std::abs(simulation.energy().relative_residual()));
      }
      EXPECT_LT(worst, 1e-8) << size << " of kind " << static_cast<int>(kind);
    }
}

// Every column of the ledger that a feature is about is filled, and with the right sign.
TEST(EnergyLedger, ColumnsFollowTheirCause) {
  const Scene scene = scenes()[1];
  const auto ledger = [&](const Integrator& integrator, const std::function<void(Model&)>& add) {
    Simulation simulation = simulation_of(scene_with(scene, integrator, {"", [&](Model& model) {
                                                                           push(model);
                                                                           add(model);
                                                                         }}));
    run(simulation, 60);
    return simulation.energy();
  };
  const Integrator lossless = trapezoidal_integrator();
  const EnergyLedger plain = ledger(lossless, [](Model&) {});
  EXPECT_GT(plain.external_work, 0);
  EXPECT_NEAR(plain.numerical, 0, 1e-11 * plain.scale());
  EXPECT_EQ(plain.gravity_work, 0);
  EXPECT_EQ(plain.radiated, 0);
  EXPECT_EQ(plain.damping, 0);
  EXPECT_EQ(plain.friction, 0);
  EXPECT_GT(ledger(thesis_integrator(), [](Model&) {}).numerical, 0.01 * plain.scale());
  EXPECT_GT(ledger(lossless, absorb).radiated, 0.01 * plain.scale());
  EXPECT_GT(ledger(lossless, damp_per_step).damping, 0.01 * plain.scale());
  EXPECT_GT(ledger(lossless, damp_per_time).damping, 0.01 * plain.scale());
  const EnergyLedger fallen = ledger(lossless, add_weight);
  EXPECT_GT(fallen.gravity_work, 0);
  const EnergyLedger moving = ledger(lossless, spin);
  EXPECT_NEAR(moving.initial.kinetic, 2600 * 0.8 * (0.05 / 2 + 0.04 * (1 + 0.64) / 12 / 2), 1e-9);
  const EnergyLedger pressed = ledger(lossless, prestress);
  const Vec3 stress(-2e5, -1e5, 3e4);
  EXPECT_NEAR(pressed.initial.strain, 4 * 0.8 / 2 * (4e10 + 1e10 - 2 * 0.25 * 2e10 + 2 * 1.25 * 9e8) / 1e9, 1e-9);
}

// A block slides to rest on a floor: what it had is spent on friction.
TEST(EnergyLedger, FrictionTakesTheEnergyOfASlidingBlock) {
  Model model = model_of({{box_ring(-5, -1, 5, 0), {}}, {box_ring(-1, 0, 1, 0.5), {}}});
  model.joints[0].friction_angle = std::atan(0.4);
  model.joints[0].law = InterfaceLaw::classical;
  model.gravity = {0, -10};
  model.supports = {{0, {-5, -1}, true, true, 1e11, Vec2::Zero(), {}},
                    {0, {5, -1}, true, true, 1e11, Vec2::Zero(), {}}};
  model.blocks[1].initial_velocity = {0.9, 0};
  model.stages = {stage_of(generalized_alpha_integrator(0), 2e-4, 1500)};
  Simulation simulation = simulation_of(std::move(model));
  run(simulation, 1500);
  const EnergyLedger& energy = simulation.energy();
  // Friction follows the normal force to 1e-9 in each of the steps.
  EXPECT_LT(std::abs(energy.relative_residual()), 1e-8);
  // It stops after v/(mu g) = 0.225 s; the weight, put on at once, makes it sink and ring by 1e-3 of that energy.
  EXPECT_LT(energy.kinetic, 1e-3 * energy.initial.kinetic);
  EXPECT_NEAR(energy.friction, energy.initial.kinetic, 0.01 * energy.initial.kinetic);
  EXPECT_NEAR(simulation.state().displacement[1](0), 0.81 / (2 * 0.4 * 10), 0.01 * 0.1);
}

// Friction only takes: also where a step is so long that the slip of a contact turns round in it.
TEST(EnergyLedger, FrictionNeverGivesBack) {
  int scenes_that_slid = 0;
  for (const Integrator& integrator : {hht_integrator(0.05), thesis_integrator(), generalized_alpha_integrator(0)})
    for (const double spin : {-6.0, -3.0, 3.0, 6.0, 9.0}) {
      Model model = model_of({{box_ring(0, 0, 1, 0.6), {}}, {box_ring(1.3, 0.2, 2.0, 1.4), {}}});
      model.joints[0].friction_angle = 0.4;
      model.joints[0].law = InterfaceLaw::classical;
      model.blocks[0].initial_velocity = {4, 0.5};
      model.blocks[0].initial_spin = spin;
      model.blocks[1].initial_velocity = {-2, -1};
      model.stages = {stage_of(integrator, 1e-3, 400, Kinematics::finite)};
      Simulation simulation = simulation_of(std::move(model));
      double before = 0;
      for (int i = 0; i < 400; ++i) {
        ASSERT_EQ(simulation.step(), Status::ok) << simulation.message();
        EXPECT_GE(simulation.energy().friction, before) << integrator.name << " spin " << spin << " step " << i;
        before = simulation.energy().friction;
      }
      scenes_that_slid += before > 0;
      EXPECT_LT(std::abs(simulation.energy().relative_residual()), 1e-9);
    }
  EXPECT_GE(scenes_that_slid, 14);  // of 15: one sticks in all of its impacts
}

// A joint is replaced by another that stores 3 J less, and the step is solved once more in the geometry that is reached
// with it: the loss is booked once.
TEST(EnergyAudit, BooksAReplacedInterfaceOnceThoughItsStepIsSolvedAgain) {
  const StepCoefficients step = step_coefficients(trapezoidal_integrator(), 1e-3);
  const Eigen::VectorXd none = Eigen::VectorXd::Zero(6);
  for (const bool solved_again : {false, true}) {
    EnergyAudit audit;
    audit.start({0, 0, 10});
    audit.interface_replaced(3);
    if (solved_again) audit.geometry_followed({0, 0, 7});
    audit.record(step, 0, {0, 0, 7}, {none, none, none, none, none, none}, none);
    EXPECT_DOUBLE_EQ(audit.ledger().law_changes, 3);
    EXPECT_DOUBLE_EQ(audit.ledger().numerical, 0);
    EXPECT_DOUBLE_EQ(audit.ledger().residual(), 0);
  }
}

// A block on a dashpot stepped by hand, with the audit told of another dashpot than the one that acted.
TEST(EnergyAudit, ReactsToAWrongDampingMatrix) {
  Model model = model_of({{box_ring(0, 0, 2, 1), {}}});
  model.blocks[0].initial_velocity = {1, 0.3};
  model.viscous_edges = {{0, {2, 0}, {2, 1}, 4e5, 2e5}};
  finish_model(model);
  for (const double error : {0.0, 1e-6, 1e-3}) {
    State state = initial_state(model);
    const BlockTerms terms = make_block_terms(model);
    const BlockDamping told = make_block_damping(model, state, 0);
    const Mat6 acting = (1 + error) * told[0].second;
    const StepCoefficients step = step_coefficients(trapezoidal_integrator(), 1e-3);
    const Mat6 mass = mass_matrix(terms.inertia[0]);
    Mat6 stiffness = Mat6::Zero();
    stiffness.bottomRightCorner<3, 3>() = terms.area[0] * terms.elasticity[0];
    state.acceleration[0] = -mass.llt().solve(acting * state.velocity[0]);
    EnergyAudit audit;
    audit.start({kinetic_energy(terms, state), 0, 0});
    const Eigen::VectorXd none = Eigen::VectorXd::Zero(6);
    Eigen::VectorXd old_force = none;
    for (int i = 0; i < 20; ++i) {
      const Vec6 rhs = mass * (step.mass_v * state.velocity[0] + step.mass_a * state.acceleration[0]) -
                       acting * (step.damping_v * state.velocity[0] + step.damping_a * state.acceleration[0]) -
                       old_force;
      const Eigen::VectorXd d =
          Mat6(step.mass * mass + step.damping * acting + step.stiffness * stiffness).llt().solve(rhs);
      const double work = inertia_work(step, terms, state, d);
      audit.dashpots_worked(step, told, state, d);
      advance_blocks(step, terms, d, state);
      deform_blocks(Kinematics::small, d, terms, state);
      Eigen::VectorXd new_force = none;
      new_force.tail<3>() = terms.area[0] * state.stress[0];
      audit.record(step, work, {kinetic_energy(terms, state), strain_energy(terms, state), 0},
                   {none, none, none, old_force, new_force, none}, d);
      old_force = new_force;
    }
    const EnergyLedger& ledger = audit.ledger();
    ASSERT_GT(ledger.radiated, 0.05 * ledger.initial.kinetic);
    // The ledger misses that share of the dashpot's work, and nothing else: in its residual by the forces that the
    // steps balanced, and for the rest in what these seem to dissipate, which with trapezoidal steps is nothing.
    EXPECT_NEAR(ledger.residual() + ledger.numerical, error * ledger.radiated, 1e-12 * ledger.scale());
    EXPECT_GT(std::abs(ledger.residual()), 0.5 * error * ledger.radiated);
  }
}

// What comes out of nothing for a while is said of stages in motion. Static steps go from one guess to the next, and
// of 24 rocks in plane strain two were warned of what a contact had stored on the way.
TEST(Energy, WhatIsGainedForAWhileIsOfStagesInMotion) {
  for (const bool settles : {false, true}) {
    EnergyAudit audit;
    audit.start({});
    audit.begin_stage(settles);
    audit.geometry_followed({.contact = 5});
    audit.geometry_followed({.contact = 1});
    EXPECT_EQ(audit.most_gained(), settles ? 0 : 1);
    audit.has_settled();
    audit.begin_stage(false);
    audit.geometry_followed({.contact = 3});
    EXPECT_EQ(audit.most_gained(), 2);
  }
}

}  // namespace
}  // namespace dda
