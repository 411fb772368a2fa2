// Coordinates of mines count from 1e5 to 1e7 m away. Rock drawn there moves as the same rock drawn at the origin:
// stiff springs turn what a place is rounded by into force, so what is computed of places counts from near by (ADR
// 102). Corners are multiples of `drawn_to` and the way from the origin whole numbers, so that nothing is rounded as
// scenes are drawn elsewhere.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "engine/simulation/random_test_support.h"
#include "engine/simulation/simulation_models.h"

namespace dda {
namespace {

constexpr double drawn_to = 0x1p-20;  // m

Vec2 as_drawn(double x, double y) { return {std::round(x / drawn_to) * drawn_to, std::round(y / drawn_to) * drawn_to}; }

// Where the corner of a grid is: off its place by lot, but for those on the outline.
class Corners {
 public:
  Corners(int columns, int rows, Random& random) : columns_(columns) {
    const double width = between(0.5, 2, random), height = between(0.5, 2, random);
    for (int j = 0; j <= rows; ++j)
      for (int i = 0; i <= columns; ++i) {
        const bool is_inside = i > 0 && i < columns && j > 0 && j < rows;
        const double off_x = between(-0.15, 0.15, random), off_y = between(-0.15, 0.15, random);
        places_.push_back(as_drawn((i + (is_inside ? off_x : 0)) * width, (j + (is_inside ? off_y : 0)) * height));
      }
  }

  [[nodiscard]] const Vec2& at(int i, int j) const { return places_[static_cast<std::size_t>(j * (columns_ + 1) + i)]; }

 private:
  int columns_;
  std::vector<Vec2> places_;
};

enum class Springs { by_young, automatic, damped, dilating };

JointMaterial joint_of(Springs springs, Random& random) {
  JointMaterial joint;
  joint.law = InterfaceLaw::classical;
  joint.friction_angle = between(0.4, 0.8, random);
  joint.automatic_stiffness = springs == Springs::automatic;
  if (springs == Springs::damped) joint.contact_damping = 0.1;
  if (springs == Springs::dilating) joint.dilation_angle = 0.1;
  return joint;
}

constexpr int columns = 5, rows = 3;

// Rock between absorbing edges, under stress, that a wave with strains of 1e-5 comes into from the left; a bolt and a
// lining beside it.
Model pressed_rock(Springs springs, unsigned seed) {
  Random random(seed);
  const Corners corners(columns, rows, random);
  Model model;
  model.materials = {rock_of(std::exp(between(std::log(1e8), std::log(1e11), random)))};
  model.joints = {joint_of(springs, random)};
  const double stress = 1e-4 * model.materials[0].young;
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i) {
      Block& block = model.blocks.emplace_back();
      block.shape.outer = {corners.at(i, j), corners.at(i + 1, j), corners.at(i + 1, j + 1), corners.at(i, j + 1)};
      block.initial_stress = {-stress, -stress, 0.1 * stress};
    }
  const double length = corners.at(columns, 0).x();
  const double speed = std::sqrt(model.materials[0].young / model.materials[0].density);
  for (int j = 0; j < rows; ++j) {
    model.edge_loads.push_back({columns * j,
                                corners.at(0, j + 1),
                                corners.at(0, j),
                                {stress / 10, stress / 20},
                                SineCycles{speed / length, 1, 0}});
    model.supports.push_back(
        {columns * j + columns - 1, corners.at(columns, j), true, true, 1e3 * stress, Vec2::Zero(), {}});
  }
  for (int i = 0; i < columns; ++i)
    model.viscous_edges.push_back({i, corners.at(i, 0), corners.at(i + 1, 0), 2600 * speed, 1300 * speed});
  Bolt& bolt = model.bolts.emplace_back();
  bolt.links = {
      {0, 2, (corners.at(0, 0) + corners.at(1, 1)) / 2, (corners.at(2, 0) + corners.at(3, 1)) / 2, 1e3 * stress, 0}};
  bolt.direction = (bolt.links[0].point_b - bolt.links[0].point_a).normalized();
  model.stages = {stage_of(generalized_alpha_integrator(0.8), length / speed / 100, 100, Kinematics::finite)};
  return model;
}

// Bricks on a held floor that falls away to one side: they slide and come to lie otherwise.
Model sliding_bricks(Springs springs, unsigned seed) {
  Random random(seed);
  Model model = grid_of(3, joint_of(springs, random), Pattern::running_bond);
  for (Block& block : model.blocks)
    for (Vec2& corner : block.shape.outer) corner = as_drawn(corner.x(), corner.y());
  model.blocks.push_back(rectangle("floor", -1, -1, 6, 1));
  model.held_blocks.resize(1);
  model.held_blocks[0].block = static_cast<int>(model.blocks.size()) - 1;
  model.gravity = {between(2, 8, random), -9.81};
  model.stages = {stage_of(generalized_alpha_integrator(0), 1e-3, 60, Kinematics::finite)};
  return model;
}

void move(Model& model, const Vec2& way) {
  for (Block& block : model.blocks)
    for (Vec2& corner : block.shape.outer) corner += way;
  for (EdgeLoad& load : model.edge_loads)
    for (Vec2* end : {&load.from, &load.to}) *end += way;
  for (PointSupport& support : model.supports) support.point += way;
  for (ViscousEdge& edge : model.viscous_edges)
    for (Vec2* end : {&edge.from, &edge.to}) *end += way;
  for (Bolt& bolt : model.bolts)
    for (BoltLink& link : bolt.links)
      for (Vec2* end : {&link.point_a, &link.point_b}) *end += way;
}

std::vector<Vec6> displacements(Model model, const Vec2& way) {
  move(model, way);
  Simulation simulation = simulation_of(std::move(model));
  while (!simulation.finished() && simulation.step() == Status::ok) continue;
  EXPECT_TRUE(simulation.finished()) << simulation.message();
  return simulation.state().displacement;
}

// The largest difference of translations and turns, as a share of the largest.
double apart(const std::vector<Vec6>& one, const std::vector<Vec6>& other) {
  double most = 0, largest = 0;
  for (std::size_t i = 0; i < one.size(); ++i) {
    most = std::max(most, (one[i] - other[i]).head<3>().cwiseAbs().maxCoeff());
    largest = std::max(largest, one[i].head<3>().cwiseAbs().maxCoeff());
  }
  return most / largest;
}

// Round-off of places, 1e-15 m wherever rock is drawn, times what springs of 10 to 1e4 E make of it; and of the
// centroids, which are kept as drawn. In places as drawn it was 1e-7 to 1e-5, 1e5 m away, and 1e-4 to 2e-2 at 1e7 m.
double round_off(Springs springs) { return springs == Springs::automatic ? 1e-6 : 2e-8; }

void expect_same_motion_far_away(Model (*scene)(Springs, unsigned)) {
  for (const Springs springs : {Springs::by_young, Springs::automatic, Springs::damped, Springs::dilating})
    for (unsigned seed = 1; seed <= 4; ++seed) {
      const Model drawn = scene(springs, seed);
      const std::vector<Vec6> here = displacements(drawn, Vec2::Zero());
      for (const double far : {1e5, 1e6, 1e7})
        EXPECT_LT(apart(here, displacements(drawn, {far, 3 - far})), round_off(springs))
            << "springs " << static_cast<int>(springs) << ", seed " << seed << ", " << far << " m away";
    }
}

TEST(FarFromOrigin, WavesGoThroughPressedRockAsAtTheOrigin) { expect_same_motion_far_away(&pressed_rock); }

TEST(FarFromOrigin, BricksSlideAsAtTheOrigin) { expect_same_motion_far_away(&sliding_bricks); }

}  // namespace
}  // namespace dda
