// Reactions, contact forces and resultants against the balance of forces and moments, taken from loads, weights and
// motions alone.
#include "engine/simulation/measured_forces.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "engine/core/error.h"
#include "engine/geometry/box.h"
#include "engine/geometry/segment.h"
#include "engine/simulation/block_system.h"
#include "engine/simulation/measured_models.h"
#include "engine/simulation/snapshot.h"

namespace dda {
namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

Vec2 centroid_of(const Simulation& simulation, int block) {
  return simulation.plan().finite_kinematics ? current_centroid(simulation.model(), simulation.state(), block)
                                             : simulation.model().blocks[at(block)].moments.centroid;
}

Vec3 about(const Vec2& point, const Vec2& place, const Vec2& force, double moment = 0) {
  return {force.x(), force.y(), moment + cross(place - point, force)};
}

// Loads, from the model's histories, and the weight of what is not held.
Vec3 applied_to(const Simulation& simulation, const std::vector<int>& blocks, const Vec2& point) {
  const Model& model = simulation.model();
  Vec3 sum = Vec3::Zero();
  for (const int block : blocks) {
    const double mass = model.is_held(block) ? 0 : model.mass_of(block);
    sum += about(point, centroid_of(simulation, block), mass * model.gravity);
    for (const PointLoad& load : model.point_loads) {
      if (load.block != block) continue;
      const Vec2 place = simulation.plan().finite_kinematics
                             ? current_position(model, simulation.state(), block, load.point)
                             : load.point;
      sum += about(point, place, evaluate(load.history, simulation.state().time) * load.force);
    }
  }
  return sum;
}

// Rates of momentum and of moment of momentum of rectangles that are hardly deformed.
Vec3 inertia_of(const Simulation& simulation, const std::vector<int>& blocks, const Vec2& point) {
  const Model& model = simulation.model();
  Vec3 sum = Vec3::Zero();
  for (const int block : blocks) {
    if (model.is_held(block)) continue;
    const Vec6& a = simulation.state().acceleration[at(block)];
    const Box box = bounding_box(model.blocks[at(block)].shape);
    const Vec2 size = box.upper - box.lower;
    const double mass = model.mass_of(block);
    // The field of the six unknowns has moment of momentum by turns, and by shear where the two sides differ.
    const double spin_up =
        mass / 12 * (size.squaredNorm() * a(2) + (size.x() * size.x() - size.y() * size.y()) / 2 * a(5));
    sum += about(point, centroid_of(simulation, block), mass * a.head<2>(), spin_up);
  }
  return sum;
}

std::vector<int> all_blocks(const Simulation& simulation) {
  std::vector<int> all(simulation.model().blocks.size());
  std::iota(all.begin(), all.end(), 0);
  return all;
}

Vec3 sum_of(const std::vector<double>& values, std::size_t first = 0) {
  return {values[first], values[first + 1], values[first + 2]};
}

constexpr double weight_of_wall = 3 * 3 * 0.7 * 2600 * 10.0;  // N

const Vec2 elsewhere(1.3, -0.7);

Measurement all_reactions() {
  Measurement measurement;
  measurement.name = "reactions";
  measurement.quantity = Quantity::reaction;
  measurement.blocks = {0};
  measurement.supports = {0};
  measurement.about = elsewhere;
  return measurement;
}

// The shaken wall with a load on what is held besides.
Model loaded_wall(Kinematics kinematics, unsigned seed = 1) {
  Model model = shaken_wall(kinematics, seed);
  model.point_loads.push_back({0, {0.5, -0.5}, {2e3, -7e3}, SineCycles{30, 20, 0}});
  return model;
}

// At rest reactions, loads and weights add up to nothing, moments too. Equilibrium is asked for to 1e-10.
TEST(Reactions, AtRestCarryLoadsAndWeights) {
  for (const Kinematics kinematics : {Kinematics::small, Kinematics::finite}) {
    for (unsigned seed = 1; seed <= 3; ++seed) {
      Model model = loaded_wall(kinematics, seed);
      model.held_blocks[0].amplitude = Vec2::Zero();
      for (PointLoad& load : model.point_loads) load.history = Constant{};
      model.measurements = {all_reactions()};
      model.stages = {stage_of(static_integrator(), 1, 200, kinematics)};
      model.stages[0].equilibrium = 1e-10;
      Simulation simulation = simulation_of(std::move(model));
      while (!simulation.finished()) ASSERT_EQ(simulation.step(), Status::ok) << simulation.message();
      const Vec3 applied = applied_to(simulation, all_blocks(simulation), elsewhere);
      const Vec3 left = sum_of(sampled(simulation)) + applied;
      EXPECT_GT(applied.norm(), weight_of_wall / 2);
      // Each of ten blocks is off by 1e-10 of the largest load at most, on arms of a few metres.
      EXPECT_LT(left.head<2>().norm(), 1e-9 * weight_of_wall) << seed;
      // In finite kinematics blocks have moved by some 1e-5 m since directions were last followed.
      EXPECT_LT(std::abs(left(2)), (kinematics == Kinematics::small ? 1e-8 : 1e-4) * weight_of_wall) << seed;
    }
  }
}

// In motion they make the momentum besides. Schemes that balance forces at the end of the step: there, to round-off of
// the accelerations, which are second differences of displacements.
TEST(Reactions, InMotionMakeTheMomentum) {
  for (const Kinematics kinematics : {Kinematics::small, Kinematics::finite}) {
    Model model = loaded_wall(kinematics);
    model.measurements = {all_reactions()};
    Simulation simulation = simulation_of(std::move(model));
    double fastest = 0;
    for (int i = 0; i < 100; ++i) {
      ASSERT_EQ(simulation.step(), Status::ok);
      const Vec3 inertia = inertia_of(simulation, all_blocks(simulation), elsewhere);
      const Vec3 left =
          sum_of(sampled(simulation)) + applied_to(simulation, all_blocks(simulation), elsewhere) - inertia;
      EXPECT_LT(left.head<2>().norm(), 1e-8 * weight_of_wall) << i;
      EXPECT_LT(std::abs(left(2)), (kinematics == Kinematics::small ? 1e-8 : 1e-3) * weight_of_wall) << i;
      fastest = std::max(fastest, inertia.head<2>().norm());
    }
    EXPECT_GT(fastest, 0.1 * weight_of_wall);
  }
}

// Schemes that balance forces within the step do so with the same weights.
TEST(Reactions, InMotionMakeTheMomentumUnderEveryIntegrator) {
  for (const Integrator& integrator : dynamic_integrators()) {
    Model model = shaken_wall(Kinematics::small);
    model.stages = {stage_of(integrator, 1e-4, 200)};
    model.measurements = {all_reactions()};
    Simulation simulation = simulation_of(std::move(model));
    const auto forces = [&] {
      return Vec3(sum_of(sampled(simulation)) + applied_to(simulation, all_blocks(simulation), elsewhere));
    };
    const auto inertia = [&] { return inertia_of(simulation, all_blocks(simulation), elsewhere); };
    for (int i = 0; i < 50; ++i) {
      const Vec3 forces_before = forces();
      const Vec3 inertia_before = inertia();
      ASSERT_EQ(simulation.step(), Status::ok);
      const Vec3 left = (1 - integrator.alpha_f) * forces() + integrator.alpha_f * forces_before -
                        (1 - integrator.alpha_m) * inertia() - integrator.alpha_m * inertia_before;
      EXPECT_LT(left.norm(), 1e-8 * weight_of_wall) << integrator.name << " step " << i;
    }
  }
}

Measurement force_between(std::vector<int> blocks, std::vector<int> others) {
  Measurement measurement;
  measurement.name = "between";
  measurement.quantity = Quantity::contact_force;
  measurement.blocks = std::move(blocks);
  measurement.others = std::move(others);
  return measurement;
}

Measurement cut(const Vec2& from, const Vec2& to, const Vec2& about) {
  Measurement measurement;
  measurement.name = "cut";
  measurement.quantity = Quantity::resultant;
  measurement.from = from;
  measurement.to = to;
  measurement.about = about;
  return measurement;
}

// The floor's contact force is all that makes it a reaction, as nothing else acts on it; and what it gets it gives.
TEST(ContactForces, AreThoseOfTheReactionAndOfTheOtherSide) {
  for (const Kinematics kinematics : {Kinematics::small, Kinematics::finite}) {
    Model model = shaken_wall(kinematics);
    std::vector<int> wall(model.blocks.size() - 1);
    std::iota(wall.begin(), wall.end(), 1);
    model.measurements = {all_reactions(), force_between({0}, wall), force_between(wall, {0})};
    model.measurements[0].supports.clear();
    for (Measurement& each : model.measurements) each.name = std::to_string(&each - model.measurements.data());
    Simulation simulation = simulation_of(std::move(model));
    run(simulation, 60);
    const std::vector<double> values = sampled(simulation);
    const double unit = std::hypot(values[0], values[1]);
    EXPECT_GT(unit, weight_of_wall / 2);
    for (std::size_t i : {0U, 1U}) {
      EXPECT_NEAR(values[3 + i], -values[i], 1e-12 * unit);
      EXPECT_NEAR(values[7 + i], values[i], 1e-12 * unit);
    }
    // The joint is level: its normal is y, and to the left of one who looks up out of the floor is -x. The floor does
    // not turn, and bricks by less than 1e-3.
    EXPECT_NEAR(values[5], values[4], (kinematics == Kinematics::small ? 1e-12 : 1e-3) * unit);
    EXPECT_NEAR(values[6], -values[3], (kinematics == Kinematics::small ? 1e-12 : 1e-3) * unit);
    EXPECT_NEAR(values[9], values[5], 1e-12 * unit);
    EXPECT_NEAR(values[10], values[6], 1e-12 * unit);
  }
}

// Each brick is pushed by its neighbours and its loads, and by nothing else.
TEST(ContactForces, MakeTheMomentumOfEachBlock) {
  Model model = shaken_wall(Kinematics::finite);
  model.supports.clear();
  for (int block = 1; block < static_cast<int>(model.blocks.size()); ++block) {
    std::vector<int> others;
    for (int other = 0; other < static_cast<int>(model.blocks.size()); ++other)
      if (other != block) others.push_back(other);
    model.measurements.push_back(force_between({block}, others));
    model.measurements.back().name = std::to_string(block);
  }
  Simulation simulation = simulation_of(std::move(model));
  for (int i = 0; i < 40; ++i) {
    ASSERT_EQ(simulation.step(), Status::ok);
    const std::vector<double> values = sampled(simulation);
    for (int block = 1; block < static_cast<int>(simulation.model().blocks.size()); ++block) {
      const std::size_t first = 4 * (at(block) - 1);
      const Vec2 left = Vec2(values[first], values[first + 1]) + applied_to(simulation, {block}, elsewhere).head<2>() -
                        inertia_of(simulation, {block}, elsewhere).head<2>();
      EXPECT_LT(left.norm(), 1e-8 * weight_of_wall) << block << " step " << i;
    }
  }
}

// Along a stretch: the floor's joint with its left brick, whose weight and half of the next row's lie on it.
TEST(ContactForces, AlongALineAreThoseOfItsJoints) {
  Model model = shaken_wall(Kinematics::small);
  model.held_blocks[0].amplitude = Vec2::Zero();
  model.point_loads.clear();
  std::vector<int> wall(model.blocks.size() - 1);
  std::iota(wall.begin(), wall.end(), 1);
  model.measurements = {force_between(wall, {0}), force_between({1}, {0}), cut({0, 0}, {1, 0}, {0, 0})};
  model.measurements[0].on_line = true;
  model.measurements[0].from = {0, 0};
  model.measurements[0].to = {1, 0};
  model.measurements[1].name = "of one";
  model.stages = {stage_of(static_integrator(), 1, 100)};
  Simulation simulation = simulation_of(std::move(model));
  run(simulation, 100);
  const std::vector<double> values = sampled(simulation);
  EXPECT_GT(values[1], 0.2 * weight_of_wall);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(values[i], values[4 + i]) << i;
  // A cut that ends there is the same joint.
  EXPECT_NEAR(values[8], values[0], 1e-12 * weight_of_wall);
  EXPECT_NEAR(values[9], values[1], 1e-12 * weight_of_wall);
}

// A cantilever of 12 x 3 bonded blocks, clamped on the left, with a force at its right end. At a section d away from it
// are the force itself and the moment of the force, whatever line the section takes through blocks and joints.
TEST(Resultants, OfACantilever) {
  for (const InterfaceLaw law : {InterfaceLaw::consistent, InterfaceLaw::classical}) {
    Model model;
    model.materials = {rock()};
    model.joints = {bond(law)};
    for (int row = 0; row < 3; ++row)
      for (int column = 0; column < 12; ++column)
        model.blocks.push_back(rectangle(fmt::format("{}.{}", row, column), column, 0.5 * row, 1, 0.5));
    for (const double y : {0.0, 0.5, 1.0})
      model.supports.push_back({static_cast<int>(24 * y), {0, y}, true, true, 1e13, {}, {}});
    model.supports.push_back({24, {0, 1.5}, true, true, 1e13, {}, {}});
    for (PointSupport& support : model.supports) support.amplitude = Vec2::Zero();
    const Vec2 force(2e4, -5e4);
    model.point_loads = {{35, {12, 1.5}, force, Constant{}}};
    // The cuts run along a joint, leaning through joints and blocks, and through the middles of blocks.
    model.measurements = {cut({6, -0.1}, {6, 1.6}, {6, 0.75}), cut({5.3, 0}, {6.9, 1.5}, {6, 0.75}),
                          cut({8.5, 0}, {8.5, 1.5}, {8.5, 0})};
    for (Measurement& each : model.measurements) each.name = std::to_string(&each - model.measurements.data());
    model.stages = {stage_of(static_integrator(), 1, 400)};
    model.stages[0].equilibrium = 1e-11;
    Simulation simulation = simulation_of(std::move(model));
    while (!simulation.finished()) ASSERT_EQ(simulation.step(), Status::ok) << simulation.message();
    const std::vector<double> values = sampled(simulation);
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3 expected = about(simulation.model().measurements[i].about, {12, 1.5}, force);
      // The right acts on the left with what acts on the right.
      EXPECT_LT((sum_of(values, 3 * i) - expected).norm(), 1e-8 * expected.norm()) << i;
    }
  }
}

// Bricks that nothing holds, bonded or dry, pushed about: the part on the left of any line moves as its loads and the
// forces across the line make it, bolts included.
TEST(Resultants, MakeTheMomentumOfTheFreePart) {
  for (const InterfaceLaw law : {InterfaceLaw::consistent, InterfaceLaw::classical}) {
    Model model = grid_of(4, bond(law), Pattern::running_bond);
    std::mt19937 random(11);
    std::uniform_real_distribution<double> force(-3e4, 3e4);
    std::uniform_real_distribution<double> frequency(20, 400);
    std::uniform_real_distribution<double> place(0.5, 3.5);
    finish_model(model);
    for (int i = 0; i < static_cast<int>(model.blocks.size()); ++i)
      model.point_loads.push_back({i,
                                   model.blocks[at(i)].moments.centroid + Vec2(0.1, -0.2),
                                   {force(random), force(random)},
                                   SineCycles{frequency(random), 50, 0}});
    Bolt bolt;
    bolt.name = "bolt";
    bolt.direction = {1, 0};
    bolt.tension_only = false;
    bolt.links = {{0, 3, {0.5, 0.35}, {3.5, 0.35}, 3e9, 0}};
    model.bolts = {bolt};
    for (int i = 0; i < 5; ++i) model.measurements.push_back(cut({place(random), -1}, {place(random), 4}, elsewhere));
    for (Measurement& each : model.measurements) each.name = std::to_string(&each - model.measurements.data());
    model.stages = {stage_of(thesis_integrator(), 1e-4, 100)};
    Simulation simulation = simulation_of(std::move(model));
    double largest = 0;
    for (int i = 0; i < 50; ++i) {
      ASSERT_EQ(simulation.step(), Status::ok);
      const std::vector<double> values = sampled(simulation);
      for (std::size_t k = 0; k < 5; ++k) {
        const Measurement& line = simulation.model().measurements[k];
        std::vector<int> left;
        for (const int block : all_blocks(simulation))
          if (cross(line.to - line.from, simulation.model().blocks[at(block)].moments.centroid - line.from) > 0)
            left.push_back(block);
        const Vec3 across = sum_of(values, 3 * k);
        const Vec3 rest = across + applied_to(simulation, left, elsewhere) - inertia_of(simulation, left, elsewhere);
        EXPECT_LT(rest.norm(), 1e-8 * weight_of_wall) << k << " step " << i;
        largest = std::max(largest, across.norm());
      }
    }
    EXPECT_GT(largest, 1e4);
  }
}

std::string refusal(Model model) {
  const Simulation simulation = simulation_of(std::move(model));
  try {
    const Probes probes(simulation);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(MeasuredForces, AreRefusedWhereNothingTouches) {
  Model apart = bar_of(2, bond(InterfaceLaw::consistent));
  for (Vec2& vertex : apart.blocks[1].shape.outer) vertex.x() += 5;
  apart.stages = {stage_of(thesis_integrator(), 1e-4, 10)};
  Model cut_air = apart;
  apart.measurements = {force_between({0}, {1})};
  cut_air.measurements = {cut({3, 0}, {3, 1}, {3, 0})};
  EXPECT_EQ(refusal(std::move(apart)),
            "measurements \"between\" is where no blocks touch, expected two sides that touch");
  EXPECT_EQ(refusal(std::move(cut_air)),
            "measurements \"cut\" is where no blocks touch, expected a line with touching blocks on its two sides");
}

// Blocks that may come to touch are measured from the start: nothing, and then what stops the fall.
TEST(ContactForces, BeginWithTheContact) {
  Model model;
  model.materials = {rock()};
  model.joints.resize(1);
  model.blocks = {rectangle("floor", -1, -1, 3, 1), rectangle("stone", 0, 0.01, 1, 0.5)};
  model.held_blocks.resize(1);
  model.gravity = {0, -10};
  model.measurements = {force_between({1}, {0})};
  model.stages = {stage_of(thesis_integrator(), 1e-3, 200, Kinematics::finite)};
  Simulation simulation = simulation_of(std::move(model));
  EXPECT_EQ(sampled(simulation)[1], 0);
  run(simulation, 20);
  EXPECT_EQ(sampled(simulation)[1], 0);  // 2 mm down after 20 ms
  run(simulation, 180);
  EXPECT_GT(sampled(simulation)[1], 0.5 * 0.5 * 2600 * 10);
}

// A run that is stopped and goes on measures the same bits.
TEST(Measurements, OfARunThatGoesOnAreThoseOfOneWithoutAStop) {
  for (const Kinematics kinematics : {Kinematics::small, Kinematics::finite}) {
    Model model = shaken_wall(kinematics);
    measure_everything(model);
    finish_model(model);
    Simulation whole(model);
    run(whole, 30);
    Simulation resumed(model);
    restore(resumed, whole.state(), save(whole));
    EXPECT_EQ(sampled(resumed), sampled(whole));
    for (int i = 0; i < 20; ++i) {
      run(whole, 1);
      run(resumed, 1);
      const std::vector<double> a = sampled(whole);
      const std::vector<double> b = sampled(resumed);
      ASSERT_EQ(std::memcmp(a.data(), b.data(), a.size() * sizeof(double)), 0) << i;
    }
  }
}

}  // namespace
}  // namespace dda
