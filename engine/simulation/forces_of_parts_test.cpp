// What is measured of forces in steps that are taken in parts, against the momentum of blocks that land: weights and
// velocities of the blocks, and histories of reactions, alone.
#include "engine/simulation/forces_of_parts.h"

#include <gtest/gtest.h>

#include "engine/geometry/rotation.h"
#include "engine/simulation/measured_models.h"
#include "engine/simulation/snapshot.h"

namespace dda {
namespace {

constexpr unsigned seeds = 30;
constexpr int steps = 300;

// Turned boxes that fall on a held floor between held walls, in steps too long for their impacts.
Model landing(unsigned seed, const Integrator& integrator) {
  std::mt19937 random(seed);
  const auto between = [&](double least, double most) {
    return std::uniform_real_distribution<double>(least, most)(random);
  };
  Model model;
  model.materials = {{"rock", 2600, 1e9, 0.2, PlaneState::stress}};
  model.joints.resize(1);
  model.joints[0].law = InterfaceLaw::classical;
  model.joints[0].friction_angle = between(0, 0.6);
  model.blocks = {rectangle("floor", -3, -1, 6, 1), rectangle("left", -3, 0, 1, 6), rectangle("right", 2, 0, 1, 6)};
  const int count = std::uniform_int_distribution<int>(1, 6)(random);
  for (int i = 0; i < count; ++i) {
    Block box = rectangle("box", -between(0.2, 0.6), -between(0.2, 0.6), between(0.6, 1.1), between(0.6, 1.1));
    const Mat2 turned = rotation(between(0, 3));
    const Vec2 place(i % 2 == 0 ? -1 : 1, 1.1 + 1.9 * (i / 2));
    for (Vec2& corner : box.shape.outer) corner = turned * corner + place;
    box.name += std::to_string(i);
    box.initial_velocity = {between(-1, 1), between(-6, 0)};
    model.blocks.push_back(box);
  }
  model.gravity = {0, -10};
  model.held_blocks.resize(3);
  for (int i = 0; i < 3; ++i) model.held_blocks[static_cast<std::size_t>(i)].block = i;
  finish_model(model);
  for (int held = 0; held < 3; ++held) measure(model, Quantity::reaction, std::vector<int>{held});
  Measurement& on_boxes = measure(model, Quantity::contact_force);
  for (int block = 3; block < 3 + count; ++block) on_boxes.blocks.push_back(block);
  on_boxes.others = {0, 1, 2};
  model.stages = {stage_of(integrator, between(1e-3, 4e-3), steps, Kinematics::finite)};
  return model;
}

Vec2 momentum_of(const Simulation& simulation) {
  Vec2 sum = Vec2::Zero();
  for (int block = 3; block < static_cast<int>(simulation.model().blocks.size()); ++block)
    sum += simulation.model().mass_of(block) * simulation.state().velocity[static_cast<std::size_t>(block)].head<2>();
  return sum;
}

double mass_of_boxes(const Model& model) {
  double sum = 0;
  for (int block = 3; block < static_cast<int>(model.blocks.size()); ++block) sum += model.mass_of(block);
  return sum;
}

struct Landing {
  std::int64_t parts = 0;
  double missed = 0;  // of the impulse, by the reactions
};

Landing land(unsigned seed, const Integrator& integrator) {
  Simulation simulation = simulation_of(landing(seed, integrator));
  const Vec2 before = momentum_of(simulation);
  const double dt = simulation.model().stages[0].dt, mass = mass_of_boxes(simulation.model());
  Vec2 impulse = Vec2::Zero();
  for (int i = 0; i < steps; ++i) {
    EXPECT_EQ(simulation.step(), Status::ok) << seed << ": " << simulation.message();
    const std::vector<double> row = sampled(simulation);
    for (const std::size_t held : {0U, 1U, 2U}) impulse += dt * Vec2(row[3 * held], row[3 * held + 1]);
    // The boxes get from the held blocks what these give, in steps in parts as in whole ones.
    EXPECT_NEAR(row[9] - row[0] - row[3] - row[6], 0, 1e-9 * mass * 1e3) << seed << ", step " << i;
    EXPECT_NEAR(row[10] - row[1] - row[4] - row[7], 0, 1e-9 * mass * 1e3) << seed << ", step " << i;
  }
  const double weight = 10 * mass * steps * dt;
  const Vec2 taken = momentum_of(simulation) - before + Vec2(0, weight);
  return {simulation.counters().steps - steps, (impulse - taken).norm() / weight};
}

// Every part of a step under the thesis' integrator gives what its forces times its length are, so nothing but
// round-off of momenta is left.
TEST(ForcesOfParts, AddUpToTheImpulse) {
  std::int64_t parts = 0;
  for (unsigned seed = 0; seed < seeds; ++seed) {
    const Landing landing = land(seed, thesis_integrator());
    parts += landing.parts;
    EXPECT_LT(landing.missed, 1e-9) << seed;
  }
  EXPECT_GT(parts, 10 * seeds);
}

// The default gives a part of what a force does in the step after it, in proportion to the length of that one: where
// lengths change that is another impulse.
TEST(ForcesOfParts, AddUpUnderTheDefaultButForItsMemory) {
  double sum = 0;
  for (unsigned seed = 0; seed < seeds; ++seed) sum += land(seed, generalized_alpha_integrator(0)).missed;
  EXPECT_LT(sum / seeds, 0.07);  // 0.054, and 0.093 by what acts at the end of the last part
}

// Parts never straddle a snapshot.
TEST(ForcesOfParts, GoOnFromSnapshots) {
  std::int64_t parts = 0;
  for (unsigned seed = 0; seed < seeds; seed += 3) {
    const Model model = landing(seed, generalized_alpha_integrator(0));
    Simulation whole = simulation_of(model);
    run(whole, 20 + 7 * static_cast<int>(seed));
    Simulation other = simulation_of(model);
    restore(other, whole.state(), save(whole));
    for (int i = 0; i < 40; ++i) {
      ASSERT_EQ(whole.step(), Status::ok);
      ASSERT_EQ(other.step(), Status::ok);
      ASSERT_EQ(sampled(whole), sampled(other)) << seed << ", step " << i;
    }
    parts += whole.counters().steps - whole.state().step;
  }
  EXPECT_GT(parts, 0);
}

}  // namespace
}  // namespace dda
