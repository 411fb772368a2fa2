// Rimless wheels that roll down a slope and lose at every impact what an inelastic one takes: contacts by the recipe of
// docs/scene.md for such impacts, against the closed form.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "engine/geometry/rotation.h"
#include "engine/simulation/simulation_models.h"

namespace dda {
namespace {

constexpr double gravity = 9.81, young = 1e9;

// A regular polygon on a slope. It turns about one corner, of which the spoke goes from -a to a about the normal of the
// slope, and on about the next.
struct Wheel {
  int spokes;
  double radius, slope;
  [[nodiscard]] double half_angle() const { return std::numbers::pi / spokes; }
  // A regular polygon of n corners has k^2 = R^2/6 (2 + cos(2 pi/n)) about its centroid.
  [[nodiscard]] double gyration_squared() const { return radius * radius / 6 * (2 + std::cos(2 * half_angle())); }
  [[nodiscard]] double about_corner() const { return gyration_squared() + radius * radius; }
  // The spin after an inelastic impact on the next corner over that before: what it has about that corner stays.
  [[nodiscard]] double kept() const {
    return (gyration_squared() + radius * radius * std::cos(2 * half_angle())) / about_corner();
  }
  // Where the fall by one side gives what the impact takes, just after it.
  [[nodiscard]] double steady_spin() const {
    const double side = 2 * radius * std::sin(half_angle());
    const double gained = 2 * gravity * side * std::sin(slope) / about_corner();
    return kept() * std::sqrt(gained / (1 - kept() * kept()));
  }
};

// Stands on a side with its leading corner at the origin, about which it turns clockwise at `spin`.
Model rolling(const Wheel& wheel, double spin) {
  Model model;
  model.materials = {{"rock", 2600, young, 0.2, PlaneState::stress}};
  model.joints.resize(1);
  model.joints[0].law = InterfaceLaw::classical;
  model.joints[0].friction_angle = std::numbers::pi / 4;
  model.joints[0].normal_spring = 0.1 * young;
  model.joints[0].contact_damping = 1;
  model.blocks = {rectangle("slope", -3, -1, 40, 1), rectangle("wheel", 0, 0, 1, 1)};
  const double a = wheel.half_angle();
  const Vec2 centre(-wheel.radius * std::sin(a), wheel.radius * std::cos(a));
  Ring& corners = model.blocks[1].shape.outer;
  corners.clear();
  for (int k = 0; k < wheel.spokes; ++k)
    corners.push_back(centre + wheel.radius * Vec2(std::sin(a + 2 * a * k), -std::cos(a + 2 * a * k)));
  for (Block& block : model.blocks)
    for (Vec2& corner : block.shape.outer) corner = rotation(-wheel.slope) * corner;
  const Vec2 arm = rotation(-wheel.slope) * centre;
  model.blocks[1].initial_spin = -spin;
  model.blocks[1].initial_velocity = -spin * Vec2(-arm.y(), arm.x());
  model.gravity = {0, -gravity};
  model.held_blocks.resize(1);
  return model;
}

// rad, in `duration` by the closed form: d(spin)/dt = g R sin(spoke + slope)/(k^2 + R^2) between impacts.
double rolled(const Wheel& wheel, double spin, double duration) {
  constexpr double dt = 1e-5;
  double spoke = -wheel.half_angle(), turned = 0;
  for (double time = 0; time < duration; time += dt) {
    const double half = spin + dt / 2 * gravity * wheel.radius * std::sin(spoke + wheel.slope) / wheel.about_corner();
    spoke += dt * half;
    turned += dt * half;
    spin = half + dt / 2 * gravity * wheel.radius * std::sin(spoke + wheel.slope) / wheel.about_corner();
    if (spoke < wheel.half_angle()) continue;
    spoke -= 2 * wheel.half_angle();
    spin *= wheel.kept();
  }
  return turned;
}

// Within 0.2 %: what is left is the time that the springs take to stop a corner, a few steps of an impact each.
TEST(RimlessWheel, RollsByInelasticImpacts) {
  constexpr double dt = 5e-4;
  for (const Wheel& wheel : {Wheel{6, 0.5, 0.22}, Wheel{8, 0.6, 0.15}, Wheel{10, 0.9, 0.12}, Wheel{12, 0.4, 0.1}}) {
    const double spin = 1.2 * wheel.steady_spin();
    const double duration = 10 * 2 * wheel.half_angle() / wheel.steady_spin();
    Model model = rolling(wheel, spin);
    const int steps = static_cast<int>(duration / dt);
    model.stages = {stage_of(generalized_alpha_integrator(0), dt, steps, Kinematics::finite)};
    Simulation simulation = simulation_of(std::move(model));
    run(simulation, steps);
    const double expected = rolled(wheel, spin, steps * dt);
    EXPECT_GT(expected, 10 * 2 * wheel.half_angle()) << wheel.spokes;
    EXPECT_NEAR(-simulation.state().displacement[1](2), expected, 0.005 * expected) << wheel.spokes;
  }
}

}  // namespace
}  // namespace dda
