// Bonds of the projected law break at their strength: blocks glued to held ground, whose joints carry what equilibrium
// alone says.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/simulation/lot.h"
#include "engine/simulation/projected_models.h"

namespace dda {
namespace {

// What a joint of length l carries at a load of 1: normal and shear force, N, and moment, N m, per m of thickness.
struct Carried {
  double normal = 0, shear = 0, moment = 0;
};

struct Scene {
  Model model;
  double length = 0;
  Carried always, by_load;
};

// A block of any size, rock and direction with its joint along its foot, without loads. Its sides run along `along`.
struct Drawn {
  double width, height;
  Vec2 along;
  [[nodiscard]] Vec2 turned(double x, double y) const { return x * along + y * Vec2(-along.y(), along.x()); }
};

Drawn draw_block(Lot& lot, Scene& scene) {
  const double size = lot.power(-1, 1), angle = lot.between(-3, 3);
  const Drawn drawn{size * lot.between(0.5, 2), size * lot.between(0.4, 2), {std::cos(angle), std::sin(angle)}};
  const auto add = [&](double left, double bottom, double right, double top) {
    scene.model.blocks.emplace_back().shape.outer = {drawn.turned(left, bottom), drawn.turned(right, bottom),
                                                     drawn.turned(right, top), drawn.turned(left, top)};
  };
  add(-drawn.width, -size, 2 * drawn.width, 0);
  add(0, 0, drawn.width, drawn.height);
  scene.model.held_blocks.resize(1);
  scene.length = drawn.width;
  Material material = rock();
  material.young = lot.power(9, 11);
  material.poisson = lot.between(0, 0.35);
  scene.model.materials = {material};
  JointMaterial joint = dry_projected(lot.between(0.2, 1));
  joint.tensile_strength = lot.power(5, 6);
  if (lot.is_one_in(3)) joint.normal_stiffness = material.young / size * lot.power(-1, 1);
  scene.model.joints = {joint};
  scene.model.stages = {stage_of(static_integrator(), 1, 40)};
  return drawn;
}

void load_top(const Drawn& drawn, double force, Scene& scene) {
  const Vec2 traction = drawn.turned(0, force / drawn.width);
  scene.model.edge_loads.push_back(
      {1, drawn.turned(drawn.width, drawn.height), drawn.turned(0, drawn.height), traction, Constant{}});
  scene.always.normal = force;
}

// Pulled off the middle of its top: the more the less is the strength by what is torn there.
Scene pulled_off(Lot& lot) {
  Scene scene;
  const Drawn drawn = draw_block(lot, scene);
  JointMaterial& joint = scene.model.joints[0];
  joint.cohesion = joint.tensile_strength * std::tan(joint.friction_angle) * lot.between(1.5, 3);
  const double off = drawn.width * lot.between(-0.5, 0.5);
  const double force = joint.tensile_strength * drawn.width;
  scene.model.point_loads.push_back(
      {1, drawn.turned(drawn.width / 2 + off, drawn.height), drawn.turned(0, force), Constant{}});
  scene.by_load = {force, 0, force * off};
  return scene;
}

// Pressed on and pushed from a side: it is sheared off, or torn off at its heel.
Scene pushed_off(Lot& lot) {
  Scene scene;
  const Drawn drawn = draw_block(lot, scene);
  JointMaterial& joint = scene.model.joints[0];
  joint.cohesion = joint.tensile_strength * lot.between(0.3, 3);
  load_top(drawn, -joint.tensile_strength * drawn.width * lot.between(0.2, 2), scene);
  const double force = joint.cohesion * drawn.width, at = drawn.height * lot.between(0.05, 0.95);
  scene.model.point_loads.push_back({1, drawn.turned(0, at), drawn.turned(force, 0), Constant{}});
  scene.by_load = {0, force, force * at};
  return scene;
}

double first_positive(double capacity, double by_load) { return by_load > 0 ? capacity / by_load : 1e30; }

// The load at which the edge is pulled by the tensile strength, by beam theory, or the whole sheared off.
double breaking_load(const Scene& scene) {
  const JointMaterial& joint = scene.model.joints[0];
  const double friction = std::tan(joint.friction_angle), l = scene.length;
  const Carried& unit = scene.by_load;
  const double torn = first_positive(joint.tensile_strength - scene.always.normal / l,
                                     unit.normal / l + 6 * std::abs(unit.moment) / (l * l));
  const double sheared = first_positive(joint.cohesion * l - friction * scene.always.normal,
                                        std::abs(unit.shear) + friction * unit.normal);
  return std::min(torn, sheared);
}

bool breaks_under(Scene scene, double load) {
  scene.model.point_loads[0].force *= load;
  Simulation simulation = simulation_of(std::move(scene.model));
  for (int i = 0; i < 40; ++i) {
    EXPECT_EQ(simulation.step(), Status::ok) << simulation.message();
    if (simulation.contacts().states[0].broken[0]) return true;
  }
  return false;
}

// Static steps come to their end from below, and are there to 1e-6 after 40 of them.
constexpr double share_off = 1e-3;

template <typename Draw>
void expect_breaks_at_its_strength(const Draw& draw) {
  for (int seed = 0; seed < 40; ++seed) {
    Lot lot(seed);
    const Scene scene = draw(lot);
    const double load = breaking_load(scene);
    EXPECT_FALSE(breaks_under(scene, (1 - share_off) * load)) << "seed " << seed;
    EXPECT_TRUE(breaks_under(scene, (1 + share_off) * load)) << "seed " << seed;
  }
}

TEST(ProjectedBond, TearsWhereItsEdgeIsPulledByItsStrength) { expect_breaks_at_its_strength(pulled_off); }
TEST(ProjectedBond, IsShearedOffAsAWholeHoweverItIsBent) { expect_breaks_at_its_strength(pushed_off); }

// Pressed and pushed from a side as before, but without tensile strength: it gapes at its heel, and holds by friction
// and by the cohesion of what stays closed, 3/2 of the way from the pressure to the nearer edge in half lengths.
struct Gaping {
  Scene scene;
  double load = 0, closed = 0;
};

Gaping pushed_till_it_gapes(Lot& lot) {
  Gaping gaping{pushed_off(lot)};
  JointMaterial& joint = gaping.scene.model.joints[0];
  joint.tensile_strength = 0;
  const double pressed = -gaping.scene.always.normal, l = gaping.scene.length;
  const Carried& unit = gaping.scene.by_load;
  // What is closed is 3/2 - slope load, where that is less than 1.
  const double slope = 3 * unit.moment / (pressed * l), friction = std::tan(joint.friction_angle) * pressed;
  gaping.load = (1.5 * joint.cohesion * l + friction) / (unit.shear + joint.cohesion * l * slope);
  gaping.closed = 1.5 - slope * gaping.load;
  return gaping;
}

bool slides_under(Scene scene, double load) {
  scene.model.point_loads[0].force *= load;
  Simulation simulation = simulation_of(std::move(scene.model));
  for (int i = 0; i < 40 && !simulation.contacts().states[0].residual[0]; ++i)
    EXPECT_EQ(simulation.step(), Status::ok) << simulation.message();
  return simulation.contacts().states[0].residual[0];
}

// Also below a quarter of the length, where the bed spreads its load (no_tension_bed.h): where the force stands is
// known without it.
TEST(ProjectedBond, SlidesWhereFrictionAndTheCohesionOfItsClosedPartAreUsedUp) {
  int gaped = 0;
  for (int seed = 0; seed < 120; ++seed) {
    Lot lot(seed);
    const Gaping gaping = pushed_till_it_gapes(lot);
    if (gaping.closed < 0.02 || gaping.closed >= 1) continue;
    ++gaped;
    EXPECT_FALSE(slides_under(gaping.scene, (1 - share_off) * gaping.load)) << "seed " << seed;
    EXPECT_TRUE(slides_under(gaping.scene, (1 + share_off) * gaping.load)) << "seed " << seed;
  }
  EXPECT_GT(gaped, 60);
}

// A block of 1 x 1 m on a plane of 30 degrees, whose joint keeps all of its cohesion as it slides and would hold
// with 1.056 of its strength if all of the foot did. The weight acts beside the middle, so that part of the foot gapes,
// a = 3 (1/2 - T/2N) of it closed under the shear T, which is what slides: T = (N tan(phi) + a C)/1.25. It goes on like
// this when the stretch has parted, at 1 % of the length; with the cohesion of the whole foot it would stop within 18
// mm. (Steps that damp keep it from rocking, with which the part would change.)
TEST(ProjectedBond, WhatSlidesOnAPartOfItsFootGoesOnWhenTheStretchHasParted) {
  const double slope = std::numbers::pi / 6, reduced = 1.25, mass = rock().density;
  const double shear = 10 * mass * std::sin(slope), normal = 10 * mass * std::cos(slope);
  const double friction = std::tan(std::numbers::pi / 9) * normal, cohesion = 1.32 * shear - friction;
  Stage settle = stage_of(static_integrator(), 1, 5, Kinematics::finite);
  settle.unlimited_strength = true;
  Model model = on_floor(rectangle("block", 0, 0, 1, 1), friction / normal / reduced, settle);
  model.stages.push_back(stage_of(thesis_integrator(), 1e-3, 400, Kinematics::finite));
  model.joints[0].cohesion = model.joints[0].residual_cohesion = cohesion / reduced;
  model.gravity = 10 * Vec2(-std::sin(slope), -std::cos(slope));
  const double carried = (friction + 1.5 * cohesion) / (reduced + 1.5 * cohesion / normal);
  Simulation simulation = simulation_of(std::move(model));
  run(simulation, 405);
  const double gone = -simulation.state().displacement[1](0), expected = (shear - carried) / mass * 0.4 * 0.4 / 2;
  EXPECT_NEAR(gone, expected, 0.05 * expected);
}

}  // namespace
}  // namespace dda
