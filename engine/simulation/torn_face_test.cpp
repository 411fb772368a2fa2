// Blocks whose glued foot tears at one edge lean on a wall of the rock that they stand on: what presses on the wall is
// what the foot lets go of.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/simulation/lot.h"
#include "engine/simulation/projected_models.h"

namespace dda {
namespace {

constexpr double gravity = 9.81;  // m/s2
constexpr int scenes = 60;
constexpr double balance = 1e-6;  // of the static stage

// A block stands at a distance from the wall of its bench and is drawn towards it, by so much of its weight that it
// turns about the edge of its foot until its top leans there.
struct Leaning {
  Model model;
  double width, height, distance, sideways;  // m; of the weight
  double weight;                             // N

  // About the edge of the foot, in the place that the block has come to.
  [[nodiscard]] double force_on_wall() const {
    const double sine = distance / height, cosine = std::sqrt(1 - sine * sine);
    const double up = height * cosine / 2 + width * sine / 2;    // of the centroid above the edge
    const double back = width * cosine / 2 - height * sine / 2;  // and behind it
    return weight * (sideways * up - back) / (height * cosine);
  }
};

Leaning draw(Lot& lot) {
  Leaning leaning;
  const double size = lot.power(-1, 1), w = size, h = size * lot.between(2, 4), density = lot.between(1500, 3000);
  leaning.width = w;
  leaning.height = h;
  leaning.distance = h * lot.between(0.001, 0.02);
  leaning.sideways = w / h * lot.between(1.3, 2.5);
  leaning.weight = density * gravity * w * h;
  const double angle = lot.between(-3, 3), side = lot.between(0, 1) < 0.5 ? 1 : -1;
  const auto place = [&](double x, double y) -> Vec2 {
    return {std::cos(angle) * side * x - std::sin(angle) * y, std::sin(angle) * side * x + std::cos(angle) * y};
  };
  Ring bench{place(-2 * w, -w),
             place(3 * w, -w),
             place(3 * w, 1.5 * h),
             place(w + leaning.distance, 1.5 * h),
             place(w + leaning.distance, 0),
             place(-2 * w, 0)};
  Ring block{place(0, 0), place(w, 0), place(w, h), place(0, h)};
  if (side < 0)
    for (Ring* each : {&bench, &block}) std::ranges::reverse(*each);
  Model& model = leaning.model;
  model.blocks.resize(2);
  model.blocks[0].shape.outer = bench;
  model.blocks[1].shape.outer = block;
  model.held_blocks.resize(1);
  model.materials = {{"rock", density, 1e8 * density * gravity * h, lot.between(0, 0.35), PlaneState::stress}};
  // The foot has friction for what the wall leaves to it of the push, k/2 + w/(2 h); the wall has none.
  model.joints = {dry_projected(lot.between(1.1, 2) * (leaning.sideways + w / h) / 2), dry_projected(0)};
  model.joints[0].cohesion = lot.power(-1, 1) * leaning.weight / w;
  model.joint_lines = {{place(w + leaning.distance, 0), place(w + leaning.distance, 1.5 * h), 1}};
  model.gravity = gravity * place(leaning.sideways, -1);
  model.stages = {settling_stage(balance)};
  return leaning;
}

// Normal forces of contacts at the wall, N.
double force_on_wall(const Simulation& simulation) {
  double pressed = 0;
  const ContactSet& contacts = simulation.contacts();
  for (std::size_t i = 0; i < contacts.interfaces.size(); ++i)
    if (contacts.interfaces[i].joint == 1) pressed -= contacts.states[i].force(0);
  return pressed;
}

TEST(TornFace, LeansOnTheWallBesideIt) {
  for (int seed = 0; seed < scenes; ++seed) {
    Lot lot(seed);
    const Leaning leaning = draw(lot);
    Simulation simulation = simulation_of(leaning.model);
    while (!simulation.finished()) ASSERT_EQ(simulation.step(), Status::ok) << "seed " << seed << simulation.message();
    EXPECT_NEAR(force_on_wall(simulation) / leaning.force_on_wall(), 1, 1e-3) << "seed " << seed;
  }
}

}  // namespace
}  // namespace dda
