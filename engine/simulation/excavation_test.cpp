// Blocks that a stage removes: what is left moves as if they had never been there, from the stress that was there.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>
#include <vector>

#include "engine/core/allocation_counter.h"
#include "engine/core/error.h"
#include "engine/simulation/joint_kinds.h"
#include "engine/simulation/simulation_models.h"
#include "engine/simulation/snapshot.h"

namespace dda {
namespace {

constexpr int settled = 3;
constexpr int moving = 60;

const Vec3 in_situ(-3e5, -5e5, 6e4);  // shear on the joints is a fifth of the pressure

// A stressed wall in held walls, all named after their places; the middle has not been removed.
Model stressed_wall(const JointMaterial& joint, Kinematics kinematics, Pattern pattern = Pattern::running_bond) {
  constexpr int size = 6;
  Model model = grid_of(size, joint, pattern);
  for (std::size_t i = 0; i < model.blocks.size(); ++i) {
    Block& block = model.blocks[i];
    block.initial_stress = in_situ;
    block.name = std::to_string(i);
    const Vec2 low = block.shape.outer[0];
    const Vec2 high = block.shape.outer[2];
    if (low.x() == 0 || low.y() == 0 || high.x() == size || high.y() > 0.7 * size - 0.1)
      model.held_blocks.emplace_back().block = static_cast<int>(i);
  }
  Stage still = stage_of(static_integrator(), 1, settled, kinematics);
  Stage motion = stage_of(generalized_alpha_integrator(0.8), 5e-5, moving, kinematics);
  model.stages = {still, motion};
  return model;
}

// Two blocks in the middle of the wall.
std::vector<int> middle_of(const Model& model) {
  std::vector<int> blocks;
  for (std::size_t i = 0; i < model.blocks.size(); ++i) {
    const Ring& ring = model.blocks[i].shape.outer;
    const Vec2 centre = (ring[0] + ring[2]) / 2;
    if (std::abs(centre.x() - 3) < 0.6 && std::abs(centre.y() - 2.1) < 0.5) blocks.push_back(static_cast<int>(i));
  }
  return blocks;
}

Model excavated_wall(const JointMaterial& joint, Kinematics kinematics, Pattern pattern = Pattern::running_bond) {
  Model model = stressed_wall(joint, kinematics, pattern);
  model.stages[1].removal.blocks = middle_of(model);
  return model;
}

// The same wall drawn without the middle, from the first moment of motion on.
Model drawn_without_middle(const JointMaterial& joint, Kinematics kinematics, Pattern pattern) {
  Model model = stressed_wall(joint, kinematics, pattern);
  std::vector<bool> gone(model.blocks.size(), false);
  for (const int block : middle_of(model)) gone[static_cast<std::size_t>(block)] = true;
  Model rest = model;
  rest.blocks.clear();
  rest.held_blocks.clear();
  for (std::size_t i = 0; i < gone.size(); ++i) {
    if (gone[i]) continue;
    if (std::ranges::any_of(model.held_blocks, [&](const HeldBlock& h) { return h.block == static_cast<int>(i); }))
      rest.held_blocks.emplace_back().block = static_cast<int>(rest.blocks.size());
    rest.blocks.push_back(model.blocks[i]);
  }
  rest.stages.erase(rest.stages.begin());
  return rest;
}

double largest_motion(const Simulation& simulation) {
  double most = 0;
  for (const Vec6& d : simulation.state().displacement) most = std::max(most, d.head<2>().norm());
  return most;
}

template <typename Body>
void in_all_walls(Body body) {
  for (const Kinematics kinematics : {Kinematics::small, Kinematics::finite})
    for (std::size_t i = 0; i < joints_of_every_kind().size(); ++i) {
      if (joints_of_every_kind()[i].law == InterfaceLaw::projected && kinematics == Kinematics::finite)
        continue;  // refused
      SCOPED_TRACE(testing::Message() << "joint " << i << (kinematics == Kinematics::small ? " small" : " finite"));
      body(joints_of_every_kind()[i], kinematics);
    }
}

TEST(Excavation, LeavesWhatWouldBeDrawnWithoutTheBlocks) {
  for (const Pattern pattern : {Pattern::stack, Pattern::running_bond}) {
    in_all_walls([&](const JointMaterial& joint, Kinematics kinematics) {
      Simulation rest = simulation_of(drawn_without_middle(joint, kinematics, pattern));
      run(rest, moving);
      Simulation simulation = simulation_of(excavated_wall(joint, kinematics, pattern));
      run(simulation, settled + moving);
      const double moved = largest_motion(rest);
      EXPECT_GT(moved, 1e-6);
      std::size_t other = 0;
      for (std::size_t i = 0; i < simulation.model().blocks.size(); ++i) {
        if (simulation.absent()[i]) continue;
        const Vec6 difference = simulation.state().displacement[i] - rest.state().displacement[other++];
        EXPECT_LT(difference.norm(), 1e-9 * moved) << i;
      }
      EXPECT_EQ(other, rest.model().blocks.size());
    });
  }
}

TEST(Excavation, BooksWhatTheBlocksHadStored) {
  in_all_walls([](const JointMaterial& joint, Kinematics kinematics) {
    Simulation simulation = simulation_of(excavated_wall(joint, kinematics));
    run(simulation, settled);
    const EnergyLedger& energy = simulation.energy();
    EXPECT_GT(energy.removed, 0);
    double stored = 0;  // in the blocks alone: uniaxial energies of the two principal directions, plane stress
    const Material& rock = simulation.model().materials[0];
    for (const int block : simulation.model().stages[1].removal.blocks) {
      const double xx = in_situ(0), yy = in_situ(1), xy = in_situ(2);
      const double density =
          (xx * xx + yy * yy - 2 * rock.poisson * xx * yy + 2 * (1 + rock.poisson) * xy * xy) / (2 * rock.young);
      stored += density * simulation.model().blocks[static_cast<std::size_t>(block)].moments.area;
    }
    // Joints that pass on the blocks' stress store nothing more; springs do.
    const InterfaceElement& first = simulation.contacts().elements.own().front();
    const bool passes_on = has_stress_rows(first) || first.law == InterfaceLaw::projected;
    const double least = stored * (1 - 1e-9);
    EXPECT_GE(energy.removed, least);
    EXPECT_LE(energy.removed, passes_on ? stored * (1 + 1e-9) : 10 * stored);
    run(simulation, moving);
    EXPECT_GT(energy.kinetic, 0);
    EXPECT_LT(std::abs(energy.relative_residual()), 1e-9);
  });
}

// The factor on what the blocks exerted.
TimeFunction kept() { return PiecewiseLinear{{0, 1}, {1, 1}}; }
TimeFunction fading(double time) { return PiecewiseLinear{{0, time}, {1, 0}}; }

TEST(Relaxation, ThatHasNotBegunMovesNothing) {
  in_all_walls([](const JointMaterial& joint, Kinematics kinematics) {
    Simulation removed = simulation_of(excavated_wall(joint, kinematics));
    run(removed, settled + moving);
    Model model = excavated_wall(joint, kinematics);
    model.stages[1].removal.relaxation = kept();
    Simulation simulation = simulation_of(std::move(model));
    run(simulation, settled + moving);
    EXPECT_LT(largest_motion(simulation), 1e-10 * largest_motion(removed));
    EXPECT_LT(std::abs(simulation.energy().relative_residual()), 1e-9);
  });
}

// The same, of a wall whose blocks have moved and turned before: a load pushed them about.
TEST(Relaxation, KeepsBlocksThatHaveMovedWhereTheyAre) {
  for (const Kinematics kinematics : {Kinematics::small, Kinematics::finite}) {
    Model model = stressed_wall(bond(InterfaceLaw::consistent), kinematics);
    model.stages[0].duration = 30;
    model.stages[1].integrator = static_integrator();
    model.stages[1].dt = 1;
    model.stages[1].duration = 10;
    const int pushed = middle_of(model).front() + 5;
    model.point_loads = {
        {pushed, Vec2(model.blocks[static_cast<std::size_t>(pushed)].shape.outer[0]), {4e5, 3e5}, Constant{}}};
    Model removing = model;
    removing.stages[1].removal = {middle_of(model), std::nullopt};
    Model keeping = model;
    keeping.stages[1].removal = {middle_of(model), kept()};
    Simulation with = simulation_of(std::move(model));
    Simulation without = simulation_of(std::move(removing));
    Simulation held = simulation_of(std::move(keeping));
    for (Simulation* each : {&with, &without, &held}) run(*each, 40);
    double change = 0;
    double caused = 0;
    for (std::size_t i = 0; i < held.absent().size(); ++i) {
      if (held.absent()[i]) continue;
      const Vec6& there = with.state().displacement[i];
      change = std::max(change, (held.state().displacement[i] - there).norm());
      caused = std::max(caused, (without.state().displacement[i] - there).norm());
    }
    // Geometry is followed when blocks are removed: turned strains and gaps measured anew both differ by their square,
    // 1e-8.
    EXPECT_LT(change, (kinematics == Kinematics::small ? 1e-10 : 2e-8) * caused);
  }
}

TEST(Relaxation, EndsWhereRemovalAtOnceDoesInAStaticStage) {
  in_all_walls([](const JointMaterial& joint, Kinematics kinematics) {
    if (!joint.bonded) return;  // what slides depends on the way
    Model model = excavated_wall(joint, kinematics);
    model.stages[1] = stage_of(static_integrator(), 1, 20, kinematics);
    model.stages[1].removal.blocks = middle_of(model);
    Model slow = model;
    slow.stages[1].removal.relaxation = fading(10);
    Simulation at_once = simulation_of(std::move(model));
    Simulation simulation = simulation_of(std::move(slow));
    run(at_once, settled + 20);
    run(simulation, settled + 20);
    const double moved = largest_motion(at_once);
    EXPECT_GT(moved, 1e-6);
    // The order in which finite strains add up makes a difference of their square.
    const double allowed = kinematics == Kinematics::small ? 1e-9 : 1e-3;
    for (std::size_t i = 0; i < simulation.absent().size(); ++i)
      EXPECT_LT((simulation.state().displacement[i] - at_once.state().displacement[i]).norm(), allowed * moved);
    EXPECT_LT(std::abs(simulation.energy().relative_residual()), 1e-9);
  });
}

// A fade of many periods excites little: the wall ends in its static place, and swings there by less than a removal at
// once makes it swing.
TEST(Relaxation, ThatIsSlowExcitesLittle) {
  const JointMaterial joint = bond(InterfaceLaw::consistent);
  Model model = excavated_wall(joint, Kinematics::small);
  model.stages[1].duration = 3000 * model.stages[1].dt;
  Model slow = model;
  slow.stages[1].removal.relaxation = fading(2500 * model.stages[1].dt);
  Simulation at_once = simulation_of(std::move(model));
  Simulation simulation = simulation_of(std::move(slow));
  run(at_once, settled + 1);
  run(simulation, settled + 3000);
  const double released = std::abs(at_once.energy().removed);
  // A straight fade of time tau leaves a mode of period T with (T/(pi tau))^2 of what a jump does. The wall is 4 m high
  // with waves of some 600 m/s: T = 13 ms beside 125 ms.
  EXPECT_LT(simulation.energy().kinetic, 1e-3 * released);
  EXPECT_LT(simulation.energy().external_work, 0);  // what held the wall was drawn back
}

TEST(Excavation, GoesOnFromASnapshotToTheBit) {
  in_all_walls([](const JointMaterial& joint, Kinematics kinematics) {
    for (const bool relaxes : {false, true}) {
      Model model = excavated_wall(joint, kinematics);
      if (relaxes) model.stages[1].removal.relaxation = fading(1e-3);
      Stage last = model.stages[1];
      last.removal = {{middle_of(model).front() + 6}, std::nullopt};
      model.stages.push_back(last);
      Simulation whole = simulation_of(model);
      finish_model(model);
      constexpr int total = settled + 2 * moving;
      for (const int stop : {1, settled, settled + 1, settled + 40, settled + moving, settled + moving + 7}) {
        Simulation first(model);
        run(first, stop);
        Simulation second(model);
        restore(second, first.state(), save(first));
        run(second, total - stop);
        if (whole.state().step == 0) run(whole, total);
        EXPECT_EQ(std::memcmp(&second.energy(), &whole.energy(), sizeof(EnergyLedger)), 0) << stop;
        for (std::size_t i = 0; i < second.absent().size(); ++i)
          EXPECT_EQ(second.state().displacement[i], whole.state().displacement[i]) << stop;
      }
    }
  });
}

TEST(Excavation, CanBeTakenBackByAnEarlierSnapshot) {
  in_all_walls([](const JointMaterial& joint, Kinematics kinematics) {
    Simulation simulation = simulation_of(excavated_wall(joint, kinematics));
    run(simulation, 1);
    const State early = simulation.state();
    const std::vector<std::byte> snapshot = save(simulation);
    run(simulation, settled + 10);
    const State later = simulation.state();
    restore(simulation, early, snapshot);
    EXPECT_TRUE(simulation.absent().empty());
    run(simulation, settled + 10);
    for (std::size_t i = 0; i < later.displacement.size(); ++i)
      EXPECT_EQ(simulation.state().displacement[i], later.displacement[i]) << i;
  });
}

TEST(Excavation, StepsAllocateNothingWhenWarm) {
  in_all_walls([](const JointMaterial& joint, Kinematics kinematics) {
    if (kinematics == Kinematics::finite) return;  // contacts that are looked for anew are listed anew
    Model model = excavated_wall(joint, kinematics);
    model.stages[1].removal.relaxation = fading(1);  // nothing breaks
    Simulation simulation = simulation_of(std::move(model));
    run(simulation, settled + 20);
    const long before = allocations_so_far();
    for (int i = 0; i < 10; ++i) ASSERT_EQ(simulation.step(), Status::ok);
    EXPECT_EQ(allocations_so_far() - before, 0);
  });
}

void expect_refused(Model model, const std::string& value) {
  try {
    finish_model(model);
    ADD_FAILURE() << "accepted: " << value;
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find(value), std::string::npos) << error.what();
  }
}

TEST(Excavation, OfWhatIsNeededIsRefused) {
  const Model good = excavated_wall(dry(0.6), Kinematics::finite);
  const int block = good.stages[1].removal.blocks[0];
  const Ring& ring = good.blocks[static_cast<std::size_t>(block)].shape.outer;
  Model model = good;
  model.stages[0].removal.blocks = {0};
  expect_refused(model, "in the first stage");
  model = good;
  model.stages[1].removal.blocks.push_back(block);
  expect_refused(model, "a second time");
  model = good;
  model.stages[1].removal.blocks.push_back(model.held_blocks[0].block);
  expect_refused(model, "which is held");
  model = good;
  model.held_blocks.clear();
  model.stages[1].removal.blocks.clear();
  for (std::size_t i = 0; i < model.blocks.size(); ++i) model.stages[1].removal.blocks.push_back(static_cast<int>(i));
  expect_refused(model, "all blocks that are left");
  model = good;
  model.stages[1].removal.blocks = {1000};
  expect_refused(model, "removed block");
  model = good;
  model.point_loads = {{block, ring[0], {1, 0}, Constant{}}};
  expect_refused(model, "on which a load acts");
  model = good;
  model.edge_loads = {{block, ring[0], ring[1], {1, 0}, Constant{}}};
  expect_refused(model, "on which a load acts");
  model = good;
  model.viscous_edges = {{block, ring[0], ring[1], 1e6, 1e6}};
  expect_refused(model, "which has a viscous boundary");
  model = good;
  model.measurements = {{"here", Quantity::stress_xx, block, -1, ring[0]}};
  expect_refused(model, "on which \"here\" is measured");
  model = good;
  model.stages[1].removal.relaxation = PiecewiseLinear{{0, 1}, {0.5, 0}};
  expect_refused(model, "0.5 at its start");
}

TEST(Excavation, OfASupportedBlockWaitsForTheSupportToGo) {
  Model model = excavated_wall(dry(0.6), Kinematics::finite);
  const int block = model.stages[1].removal.blocks[0];
  PointSupport support{
      block, model.blocks[static_cast<std::size_t>(block)].shape.outer[0], true, true, 1e9, Vec2::Zero(), {}};
  model.supports = {support};
  expect_refused(model, "which a support holds");
  model.supports[0].last_stage = 0;
  expect_refused(model, "the force that one has left");
  model.supports[0].takes_force_along = true;
  Simulation simulation = simulation_of(model);
  run(simulation, settled + moving);
  EXPECT_LT(std::abs(simulation.energy().relative_residual()), 1e-9);
}

}  // namespace
}  // namespace dda
