// Water in the joints of rock by lot: the joints carry what the stress of the blocks has beyond it.
#include "engine/simulation/face_loads.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "engine/contact/interface.h"
#include "engine/geometry/cut_pieces.h"
#include "engine/simulation/projected_models.h"

namespace dda {
namespace {

constexpr double in_situ = -5e6;    // Pa, in all directions
constexpr double pressure = 1e6;    // Pa, at the origin
constexpr double gradient = 0.1e6;  // Pa/m, downwards

double pressure_at(const Vec2& place) { return pressure - gradient * place.y(); }

// One that passes stress on until it breaks, which nothing here does.
JointMaterial breakable_consistent() {
  JointMaterial joint;
  joint.law = InterfaceLaw::consistent;
  joint.cohesion = joint.tensile_strength = 1e9;
  return joint;
}

// So many columns and rows of four-sided blocks of about 1 m whose corners lie anywhere.
Model quadrilaterals(int columns, int rows, const JointMaterial& joint, SeededNumbers& random) {
  Model model;
  model.materials = {rock()};
  model.joints = {joint};
  std::vector<std::vector<Vec2>> corners;
  for (int row = 0; row <= rows; ++row) {
    corners.emplace_back();
    for (int column = 0; column <= columns; ++column)
      corners.back().emplace_back(column + random.number(-0.25, 0.25), row + random.number(-0.25, 0.25));
  }
  for (std::size_t row = 0; row < static_cast<std::size_t>(rows); ++row)
    for (std::size_t i = 0; i < static_cast<std::size_t>(columns); ++i) {
      Block& block = model.blocks.emplace_back(rectangle(std::to_string(row) + "." + std::to_string(i), 0, 0, 1, 1));
      block.shape.outer = {corners[row][i], corners[row][i + 1], corners[row + 1][i + 1], corners[row + 1][i]};
      block.initial_stress = {in_situ, in_situ, 0};
    }
  return model;
}

// What presses on the outside as much as the stress of the rock, and water in all joints, by this history.
void put_into_water(const TimeFunction& history, Model& model) {
  finish_model(model);
  const std::vector<Interface> joints = find_interfaces(model);
  for (std::size_t i = 0; i < model.blocks.size(); ++i) {
    const Ring& ring = model.blocks[i].shape.outer;
    for (std::size_t k = 0; k < ring.size(); ++k) {
      const Vec2 from = ring[k], to = ring[(k + 1) % ring.size()];
      const bool is_outside = std::ranges::none_of(
          joints, [&](const Interface& joint) { return (joint.from + joint.to - from - to).norm() < 1e-9; });
      const Vec2 along = (to - from).normalized();
      if (is_outside)
        model.edge_loads.push_back(
            {static_cast<int>(i), from, to, in_situ * Vec2(along.y(), -along.x()), Constant{}, {}, {0, 0}});
    }
  }
  for (const Interface& joint : joints) {
    if (joint.length == 0) continue;
    const Vec2 push = pressure_at((joint.from + joint.to) / 2) * joint.normal;
    const Vec2 rise = (pressure_at(joint.to) - pressure_at(joint.from)) / 2 * joint.normal;
    model.edge_loads.push_back({joint.block_a, joint.from, joint.to, -push, history, {}, -rise});
    model.edge_loads.push_back({joint.block_b, joint.to, joint.from, push, history, {}, -rise});
  }
}

// By how much of the pressure stress is off, at most, and how far a block has gone, as a share of p/E of its size.
struct Off {
  double stress = 0, motion = 0, traction = 0;
};

Off off_after(int steps, Model model) {
  Simulation simulation = simulation_of(std::move(model));
  run(simulation, steps);
  Off off;
  for (std::size_t i = 0; i < simulation.model().blocks.size(); ++i) {
    off.stress = std::max(off.stress, (simulation.state().stress[i] - Vec3(in_situ, in_situ, 0)).norm() / pressure);
    off.motion = std::max(off.motion, simulation.state().displacement[i].norm() * rock().young / pressure);
  }
  const ContactSet& contacts = simulation.contacts();
  for (std::size_t k = 0; k < contacts.interfaces.size(); ++k) {
    const Interface& joint = contacts.interfaces[k];
    if (joint.length == 0) continue;
    const Vec2 carried = mean_traction(simulation.model(), joint, contacts.elements.own()[k], contacts.states[k]);
    const double expected = in_situ + pressure_at((joint.from + joint.to) / 2);
    off.traction = std::max(off.traction, (carried - Vec2(expected, 0)).norm() / pressure);
  }
  EXPECT_LT(std::abs(simulation.energy().relative_residual()), 1e-9);
  return off;
}

// Closed joints do not feel water, whatever it does: the stress stays, and the joints carry less by the pressure. The
// law set what they carried against the whole stress, which was then off by up to 1.5 of the pressure.
TEST(FaceLoads, MoveNothingWhereJointsAreClosed) {
  const std::vector<Stage> kinds = {stage_of(static_integrator(), 1, 4, Kinematics::small),
                                    stage_of(static_integrator(), 1, 4, Kinematics::finite),
                                    stage_of(generalized_alpha_integrator(0.8), 1e-5, 8, Kinematics::small),
                                    stage_of(trapezoidal_integrator(), 1e-5, 8, Kinematics::finite)};
  for (std::uint64_t seed = 0; seed < 80; ++seed) {
    SeededNumbers random(seed);
    const JointMaterial joint = seed < 40 ? dry_projected(0.6) : breakable_consistent();
    Model model = quadrilaterals(2 + static_cast<int>(seed % 3), 2 + static_cast<int>(seed / 3 % 3), joint, random);
    const Stage& stage = kinds[seed % kinds.size()];
    const bool changes = seed % 8 >= 4;
    const auto steps = static_cast<int>(stage.steps());
    const double rises_for = stage.dt * steps;
    put_into_water(changes ? TimeFunction(SineCycles{0.25 / rises_for, 1, 0}) : TimeFunction(Constant{}), model);
    model.stages = {stage};
    const Off off = off_after(steps, std::move(model));
    EXPECT_LT(off.stress, 1e-9) << "seed " << seed;
    EXPECT_LT(off.motion, 1e-9) << "seed " << seed;
    EXPECT_LT(off.traction, 1e-9) << "seed " << seed;
  }
}

// Where joints open and slide by it, or give way as consistent ones do, the ledger closes too.
TEST(FaceLoads, BalanceInTheLedgerWhereJointsOpen) {
  for (std::uint64_t seed = 0; seed < 48; ++seed) {
    SeededNumbers random(seed);
    Model model = quadrilaterals(3, 3, seed < 24 ? dry_projected(0.3) : breakable_consistent(), random);
    for (const int block : {0, 1, 2}) model.held_blocks.emplace_back().block = block;
    model.gravity = {2, -10};
    const std::vector<Integrator> integrators = dynamic_integrators();
    const Kinematics kinematics = seed % 2 == 0 ? Kinematics::small : Kinematics::finite;
    model.stages = {stage_of(integrators[seed / 2 % 4], 1e-4, 60, kinematics)};
    put_into_water(SineCycles{400, 2, 0}, model);
    std::erase_if(model.edge_loads,
                  [](const EdgeLoad& load) { return std::holds_alternative<Constant>(load.history); });
    Simulation simulation = simulation_of(std::move(model));
    run(simulation, 60);
    EXPECT_LT(std::abs(simulation.energy().relative_residual()), 1e-9) << "seed " << seed;
    EXPECT_LE(simulation.energy().gained(), 1e-2 * simulation.energy().scale()) << "seed " << seed;
  }
}

}  // namespace
}  // namespace dda
