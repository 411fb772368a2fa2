// Sides that go with columns of their blocks.
#include "engine/simulation/free_field.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "engine/contact/make_contacts.h"
#include "engine/core/allocation_counter.h"
#include "engine/core/error.h"
#include "engine/geometry/rotation.h"
#include "engine/simulation/free_field_columns.h"
#include "engine/simulation/free_field_models.h"
#include "engine/simulation/run_so_far.h"
#include "engine/simulation/simulation_models.h"
#include "engine/terms/load.h"

namespace dda {
namespace {

using namespace free_field;

// Every row moves as the columns do: to round-off (times the condition of the ties) where vertical joints have springs,
// else up to what vertical joints give way in waves of 15 blocks and shorter (measured 2e-3, with margin).
TEST(FreeField, SidesGoWithTheColumns) {
  for (const auto& [law, tolerance] : {std::pair(InterfaceLaw::consistent, 5e-3), {InterfaceLaw::classical, 1e-8}})
    for (const Integrator& integrator : dynamic_integrators()) {
      Model model = shaken_grid(bond(law));
      model.stages[0].integrator = integrator;
      Simulation simulation = simulation_of(std::move(model));
      EXPECT_LT(difference_from_columns(simulation, 200), tolerance) << integrator.name;
      EXPECT_LT(std::abs(simulation.energy().relative_residual()), 1e-11);
    }
}

TEST(FreeField, SidesWithDashpotsAloneAreHeldBack) {
  Simulation with = simulation_of(shaken_grid(bond(InterfaceLaw::consistent)));
  Model model = shaken_grid(bond(InterfaceLaw::consistent));
  model.free_field_sides.clear();
  Simulation without = simulation_of(std::move(model));
  EXPECT_EQ(without.free_field_columns(), nullptr);
  double difference = 0, largest = 0;
  for (int i = 0; i < 200; ++i) {
    run(with, 1);
    run(without, 1);
    const Vec6& expected = with.state().velocity[at((rows - 1) * columns)];
    difference = std::max(difference, (without.state().velocity[at((rows - 1) * columns)] - expected).norm());
    largest = std::max(largest, expected.norm());
  }
  EXPECT_GT(difference, 0.2 * largest);
}

// The general path and moving geometry: strains of 1e-6 between the two.
TEST(FreeField, IsTheSameInAllPaths) {
  Simulation linear = simulation_of(shaken_grid(bond(InterfaceLaw::consistent)));
  Simulation judged = simulation_of(shaken_grid(strong(InterfaceLaw::consistent)));
  Model model = shaken_grid(bond(InterfaceLaw::consistent));
  model.stages[0].kinematics = Kinematics::finite;
  Simulation finite = simulation_of(std::move(model));
  for (Simulation* simulation : {&linear, &judged, &finite}) run(*simulation, 150);
  const std::size_t corner = at((rows - 1) * columns);
  const Vec6& expected = linear.state().velocity[corner];
  EXPECT_LT((judged.state().velocity[corner] - expected).norm(), 1e-10 * expected.norm());
  EXPECT_LT((finite.state().velocity[corner] - expected).norm(), 1e-4 * expected.norm());
}

// Under its weight, settled with free sides from the start.
Model heavy_grid(const JointMaterial& joint, int first_stage) {
  Model model = shaken_grid(joint);
  model.viscous_edges.clear();
  model.free_field_sides.clear();
  add_sides(first_stage, model);
  model.gravity = {0, -9.81};
  std::get<SineCycles>(model.held_blocks[0].history).start = 1000;
  Stage settle = stage_of(static_integrator(), 10, 60);
  settle.name = "settle";
  settle.equilibrium = 1e-10;
  model.stages.insert(model.stages.begin(), settle);
  return model;
}

void expect_settles(Simulation& simulation, double settled_at) {
  while (simulation.state().time < settled_at) ASSERT_EQ(simulation.step(), Status::ok) << simulation.message();
}

void expect_rest(Simulation& simulation, double settled_at) {
  expect_settles(simulation, settled_at);
  // No strain along x anywhere: the blocks at the sides carry what those in the middle do, up to what the stress varies
  // within a block, by which the joints inside give way (the same with rigid walls).
  const Vec3 foot = simulation.state().stress[2];
  const Vec3 side = simulation.state().stress[0];
  EXPECT_LT(foot.y(), -9.81 * 2500 * 3);
  EXPECT_LT((side - foot).norm(), 3e-3 * foot.norm());
  run(simulation, 200);
  for (const Vec6& velocity : simulation.state().velocity)
    EXPECT_LT(velocity.cwiseAbs().maxCoeff(), 1e-8 * 9.81 * 0.02);  // of a free fall for as long
}

TEST(FreeField, CarriesTheStressOfGravity) {
  Simulation simulation = simulation_of(heavy_grid(bond(InterfaceLaw::consistent), 0));
  expect_rest(simulation, 600);
  EXPECT_TRUE(simulation.finished());
}

// Largest difference of the settled stress of any block from its column's, of the largest, and the strain of the lowest
// under the weight.
std::pair<double, double> settled_difference_and_strain(Kinematics kinematics, double young) {
  Model model = heavy_grid(bond(InterfaceLaw::classical), 0);  // springs of vertical joints are in the ties as well
  for (Material& material : model.materials) material.young = young;
  for (Stage& stage : model.stages) stage.kinematics = kinematics;
  Simulation simulation = simulation_of(std::move(model));
  expect_settles(simulation, 600);
  double difference = 0, largest = 0;
  for (int block = 0; block < rows * columns; ++block) {
    const Vec3& column = simulation.free_field_columns()->state().stress[at(block / columns)];
    difference = std::max(difference, (simulation.state().stress[at(block)] - column).norm());
    largest = std::max(largest, column.norm());
  }
  return {difference / largest, largest / young};
}

// What ties hold goes to the side as it is, however far the weight has shortened columns and edges. What is left is of
// second order in the strain (measured 4.0 and 4.5 strain^2); taken as a traction on lengths of two
// geometries the forces would be wrong by 0.06 strain, 9 and 94 times the tolerance.
TEST(FreeField, CarriesTheStressOfAWeightThatCompressesTheBlocks) {
  for (const double young : {2e8, 2e9}) {
    const auto [difference, strain] = settled_difference_and_strain(Kinematics::finite, young);
    EXPECT_GT(strain, 1e5 / young);
    EXPECT_LT(difference, 10 * strain * strain);
    EXPECT_LT(settled_difference_and_strain(Kinematics::small, young).first, 1e-9);  // round-off
  }
}

// Rollers hold the sides while the weight settles; the free field brings what is new from then on.
TEST(FreeField, BeginsWithAStageAndLeavesWhatRollersHeld) {
  Model model = heavy_grid(bond(InterfaceLaw::consistent), 1);
  hold_sides_first(1e14, model);
  Simulation simulation = simulation_of(std::move(model));
  expect_rest(simulation, 600);
}

// Model and columns come to rest before the stage is over, each at its time; both are shaken from its end on, step by
// step.
TEST(FreeField, KeepsStepAfterAStaticStageThatEndsEarly) {
  Model model = heavy_grid(bond(InterfaceLaw::classical), 0);
  std::get<SineCycles>(model.held_blocks[0].history).start = 600;
  Simulation simulation = simulation_of(std::move(model));
  expect_settles(simulation, 600);
  EXPECT_LT(simulation.state().step, 60);
  EXPECT_LT(difference_from_columns(simulation, 200), 1e-7);  // round-off, as without weight, of clocks at 600 s
}

// Columns end a stage one step before the model, and a run that ends with them says why, as does one that is restored.
TEST(FreeField, SaysThatItsColumnsAreOutOfBalance) {
  Model model = heavy_grid(bond(InterfaceLaw::consistent), 0);
  model.stages[0].dt = 1e-3;  // too short to settle in 60 steps
  model.stages[0].duration = 0.06;
  Simulation simulation = simulation_of(model);
  Status status = Status::ok;
  while (status == Status::ok && !simulation.finished()) status = simulation.step();
  EXPECT_EQ(status, Status::not_in_equilibrium);
  EXPECT_EQ(simulation.state().step, 59);
  EXPECT_NE(simulation.message().find("columns of the free field: static stage \"settle\" ended"), std::string::npos)
      << simulation.message();
  EXPECT_EQ(unbalanced_end(simulation), simulation.message());
}

// In-situ stress in equilibrium with its surroundings: nothing moves.
TEST(FreeField, CarriesInitialStress) {
  Model model = shaken_grid(bond(InterfaceLaw::consistent));
  for (int i = 0; i < rows * columns; ++i) model.blocks[at(i)].initial_stress = {-3e6, 0, 0};
  std::get<SineCycles>(model.held_blocks[0].history).start = 1000;
  Simulation simulation = simulation_of(std::move(model));
  run(simulation, 200);
  const double speed = 3e6 / 1.2e7;  // of a side that nothing held
  for (const Vec6& velocity : simulation.state().velocity) EXPECT_LT(velocity.cwiseAbs().maxCoeff(), 1e-10 * speed);
}

TEST(FreeField, ColumnsHaveTheSidesBlocksJointsAndBase) {
  Model model = shaken_grid(bond(InterfaceLaw::classical));
  model.joints.push_back(strong(InterfaceLaw::consistent));
  model.joint_of_block_pair[{columns, 2 * columns}] = 1;  // on the left, above the second row
  finish_model(model);
  const FreeFieldColumns made = make_free_field_columns(model, make_contacts(model));
  ASSERT_EQ(made.model.blocks.size(), at(2 * (rows + 1)));
  EXPECT_EQ(made.blocks.size(), at(2 * rows));
  EXPECT_EQ(made.blocks[at(rows)], rows + 1);
  ASSERT_EQ(made.model.held_blocks.size(), 2U);
  EXPECT_EQ(made.model.held_blocks[0].block, rows);
  EXPECT_EQ(made.model.held_blocks[0].kind, MotionKind::acceleration);
  EXPECT_EQ(made.model.blocks[0].material, 0);
  EXPECT_EQ(made.model.blocks[at(rows - 1)].material, 1);
  EXPECT_EQ(made.model.blocks[at(rows - 1)].moments.centroid.y(), rows - 0.5);
  EXPECT_TRUE(made.model.joint_between(0, 1).bonded);
  EXPECT_EQ(made.model.joint_between(0, 1).law, InterfaceLaw::classical);
  EXPECT_FALSE(made.model.joint_between(1, 2).bonded);
  EXPECT_EQ(made.model.joint_between(1, 2).law, InterfaceLaw::consistent);
  EXPECT_TRUE(made.model.joint_between(0, rows).bonded);
}

// What acts on the underside and the top goes along, as do the springs below, by their stiffness per length.
TEST(FreeField, ColumnsHaveTheLoadsSupportsAndDashpotsOfTheirFootAndHead) {
  Model model = shaken_grid(bond(InterfaceLaw::classical));
  model.held_blocks.clear();
  model.blocks.pop_back();
  for (int column = 0; column < columns; ++column) {
    model.viscous_edges.push_back({column, {1.0 * column, 0}, {column + 1.0, 0}, 1e7, 6e6});
    model.edge_loads.push_back({column, {1.0 * column, 0}, {column + 1.0, 0}, {1e5, 0}, SineCycles{100, 1, 0}});
    model.edge_loads.push_back(
        {(rows - 1) * columns + column, {1.0 * column, rows}, {column + 1.0, rows}, {0, -1e4}, SineCycles{100, 1, 0}});
    for (const double x : {column + 0.0, column + 1.0}) {
      PointSupport& below = model.supports.emplace_back();
      below.block = column;
      below.point = {x, 0};
      below.stiffness = 3e9;
    }
  }
  finish_model(model);
  const FreeFieldColumns made = make_free_field_columns(model, make_contacts(model));
  EXPECT_EQ(made.model.blocks.size(), at(2 * rows));
  EXPECT_EQ(made.model.viscous_edges.size(), 2U);
  EXPECT_EQ(made.model.edge_loads.size(), 4U);
  double below = 0;
  for (const PointSupport& support : made.model.supports)
    if (!support.partner && support.block == 0) below += support.stiffness;
  EXPECT_EQ(below, 6e9);
  Simulation simulation = simulation_of(std::move(model));
  EXPECT_LT(difference_from_columns(simulation, 200), 1e-8);  // round-off, as with a base
}

// A stage names the blocks that come in by their place among those of the whole; the columns took it for theirs.
TEST(FreeField, ColumnsStayWhatTheyAreWhereBlocksComeIn) {
  const auto shaken = [](bool one_comes_in) {
    Model model = shaken_grid(bond(InterfaceLaw::consistent));
    model.stages.push_back(model.stages[0]);
    if (one_comes_in) model.stages[1].rock.added = {2 * columns + 2};
    return simulation_of(std::move(model));
  };
  Simulation with = shaken(true), without = shaken(false);
  for (Simulation* simulation : {&with, &without}) run(*simulation, 300);
  for (std::size_t i = 0; i < at(2 * rows + 2); ++i)
    EXPECT_EQ(with.free_field_columns()->state().velocity[i], without.free_field_columns()->state().velocity[i]) << i;
}

TEST(FreeField, AllocatesNothingInAWarmStep) {
  for (const JointMaterial& joint : {bond(InterfaceLaw::consistent), strong(InterfaceLaw::classical)}) {
    Simulation simulation = simulation_of(shaken_grid(joint));
    run(simulation, 20);
    const long before = allocations_so_far();
    for (int i = 0; i < 20; ++i) EXPECT_EQ(simulation.step(), Status::ok);
    EXPECT_EQ(allocations_so_far() - before, 0);
  }
}

// Stress in the columns from the start, beside blocks that have turned and grown: the same force, where the middle of
// the edge is now.
TEST(FreeField, ActsInTheMiddleOfTheMovedEdge) {
  Model model = shaken_grid(bond(InterfaceLaw::consistent));
  for (int i = 0; i < rows * columns; ++i) model.blocks[at(i)].initial_stress = {-3e6, 0, 5e5};
  finish_model(model);
  const ContactSet contacts = make_contacts(model);
  State state = initial_state(model);
  FreeField field(model, contacts, state);
  for (Mat2& deformation : state.deformation) deformation = 1.5 * rotation(0.4);
  field.update_geometry(model, state, 0);
  Eigen::VectorXd force = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(6 * model.blocks.size()));
  field.add_loads_at(0, 0, force);
  for (const bool right : {false, true}) {
    const double outward = right ? 1 : -1;
    const int block = columns + (right ? columns - 1 : 0);
    const Vec6 expected = point_load(1.5 * rotation(0.4) * Vec2(outward / 2, 0), outward * Vec2(-3e6, 5e5));
    EXPECT_LT((force.segment<6>(6 * block) - expected).norm(), 1e-12 * expected.norm());
  }
}

// A step cut in two lies between the ends of a step of the columns.
TEST(FreeField, IsLinearWithinAStepOfTheColumns) {
  Simulation simulation = simulation_of(shaken_grid(bond(InterfaceLaw::consistent)));
  Model model = shaken_grid(bond(InterfaceLaw::consistent));
  finish_model(model);
  FreeField field(model, simulation.contacts(), simulation.state());
  ASSERT_EQ(field.advance_to(1e-4, 1e-4), Status::ok);
  ASSERT_EQ(field.advance_to(2e-4, 1e-4), Status::ok);
  const auto unknowns = static_cast<Eigen::Index>(6 * model.blocks.size());
  Eigen::VectorXd first = Eigen::VectorXd::Zero(unknowns), middle = first, last = first;
  field.add_loads_at(1e-4, 0, first);
  field.add_loads_at(1.5e-4, 0, middle);
  field.add_loads_at(2e-4, 0, last);
  EXPECT_GT((last - first).norm(), 0);
  EXPECT_LT((middle - (first + last) / 2).norm(), 1e-12 * last.norm());
}

}  // namespace
}  // namespace dda
