// Two free blocks that meet head-on, by lot: no faster apart than together, whatever the length of steps.
#include "engine/simulation/acceleration_memory.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "engine/geometry/rotation.h"
#include "engine/simulation/simulation_models.h"

namespace dda {
namespace {

Ring turned(Ring ring, double angle) {
  for (Vec2& vertex : ring) vertex = rotation(angle) * vertex;
  return ring;
}

struct Pair {
  double height, length_a, length_b, gap, turn, speed, dt;

  [[nodiscard]] Simulation thrown() const {
    Model model = model_of({{turned(box_ring(-length_a, 0, 0, height), turn), {}},
                            {turned(box_ring(gap, 0, gap + length_b, height), turn), {}}},
                           {"rock", 2600, 20e9, 0.25, PlaneState::stress});
    model.joints[0].law = InterfaceLaw::classical;
    model.joints[0].friction_angle = 0.5;
    model.blocks[0].initial_velocity = rotation(turn) * Vec2(speed, 0);
    model.stages = {stage_of(generalized_alpha_integrator(0), dt, 60, Kinematics::finite)};
    return simulation_of(std::move(model));
  }
};

double speed_apart(const Simulation& simulation, double turn) {
  const State& state = simulation.state();
  const Vec2 apart = state.velocity[1].head<2>() - state.velocity[0].head<2>();
  return apart.dot(rotation(turn) * Vec2(1, 0));
}

// A step is up to a thousand times as long as a wave takes through a block, so that most impacts lie within one part of
// one step. Elastic blocks keep some of the energy, so 1 is the most; the first part of a step moves them by up to its
// closure of springs, 1e-3 of what they travel in it.
TEST(AccelerationMemory, BlocksFlyApartNoFasterThanTheyHaveMet) {
  std::mt19937 random(31);
  const auto number = [&](double low, double high) { return std::uniform_real_distribution(low, high)(random); };
  double fastest = 0;
  for (int scene = 0; scene < 200; ++scene) {
    Pair pair{};
    pair.height = std::pow(10, number(-2, 1));
    pair.length_a = pair.height * number(0.5, 3);
    pair.length_b = pair.height * number(0.5, 3);
    pair.turn = scene % 2 == 0 ? 0 : number(-3, 3);
    pair.dt = pair.height / 2800 * std::pow(10, number(0, 3));
    pair.speed = 0.01 * pair.height / pair.dt * number(0.05, 1);  // up to a hundredth of the block in a step
    pair.gap = pair.speed * pair.dt * number(3, 8);
    Simulation simulation = pair.thrown();
    while (!simulation.finished()) ASSERT_EQ(simulation.step(), Status::ok) << scene;
    const double restitution = speed_apart(simulation, pair.turn) / pair.speed;
    EXPECT_LE(restitution, 1 + 1e-3) << "scene " << scene << ", dt " << pair.dt;
    EXPECT_GT(restitution, -1e-9) << "scene " << scene << ": passed through, or never met";
    fastest = std::max(fastest, restitution);
  }
  EXPECT_GT(fastest, 0.5);  // or nothing has met
}

TEST(AccelerationMemory, HalvesWhatWasGainedAndKeepsTheRest) {
  AccelerationMemory memory;
  const Vec6 before = Vec6::Constant(-9.81);
  memory.note_start({before});
  std::vector<Vec6> now{before};
  memory.halve(now);
  EXPECT_EQ(now[0], before);
  now[0](0) -= 8;
  now[0](2) = 1;  // faded
  memory.halve(now);
  EXPECT_DOUBLE_EQ(now[0](0), before(0) - 4);
  EXPECT_EQ(now[0](1), before(1));
  EXPECT_EQ(now[0](2), 1);
}

// A block that turns has all of its steps cut, and what an early push has left in its accelerations must fade all the
// same: without loads it keeps its spin. Pushed for 50 ms, and looked at from 1 s to 5 s.
TEST(AccelerationMemory, ABlockThatWasPushedDoesNotGoOnToSpinUp) {
  for (const double force : {5e3, 50e3}) {
    Model model = model_of({{box_ring(0, 0, 1, 1), {}}}, {"rock", 2600, 20e9, 0.25, PlaneState::stress});
    model.joints[0].law = InterfaceLaw::classical;
    model.point_loads.push_back({0, {1, 1}, {0, force}, PiecewiseLinear{{0, 0.05, 0.0500001}, {1, 1, 0}}});
    model.stages = {stage_of(generalized_alpha_integrator(0), 0.05, 100, Kinematics::finite)};
    Simulation simulation = simulation_of(std::move(model));
    double early = 0;
    for (int step = 0; !simulation.finished(); ++step) {
      ASSERT_EQ(simulation.step(), Status::ok);
      if (step == 20)
        early = simulation.state().velocity[0](2);  // what the push has left has gone by half in each part
    }
    EXPECT_GT(early, 0.1);
    EXPECT_NEAR(simulation.state().velocity[0](2), early, 1e-3 * early) << force;  // 2e-5 of an initial spin is lost
  }
}

}  // namespace
}  // namespace dda
