#include "verification/exact/block_on_incline.h"

#include <cmath>

namespace exact {
namespace {

double diagonal_squared(const InclinedBlock& block) { return block.width * block.width + block.height * block.height; }

// Angular acceleration about a toe that does not slide.
double turning(const InclinedBlock& block, double gravity) {
  const double moment = block.height * std::sin(block.slope) - block.width * std::cos(block.slope);
  return 1.5 * gravity * moment / diagonal_squared(block);
}

// Turning about a toe that slides: weight and friction give N = m (g cos a + A b/2), its moment A.
InclineMotion sliding_and_toppling(const InclinedBlock& block, double gravity) {
  const double mu = std::tan(block.friction);
  const double inertia = diagonal_squared(block) / 12;  // over the mass, about the centroid
  const double arm = (mu * block.height - block.width) / 2;
  const double normal_of_weight = gravity * std::cos(block.slope);
  const double turning = normal_of_weight * arm / (inertia - block.width / 2 * arm);
  const double normal = normal_of_weight + turning * block.width / 2;
  return {gravity * std::sin(block.slope) - mu * normal - turning * block.height / 2, turning};
}

}  // namespace

InclineMotion initial_motion(const InclinedBlock& block, double gravity) {
  const double mu = std::tan(block.friction);
  const double steepness = std::tan(block.slope);
  const double foot = block.width / block.height;
  if (steepness <= mu && steepness <= foot) return {};
  if (mu <= foot) return {gravity * (std::sin(block.slope) - mu * std::cos(block.slope)), 0};
  const double turn = turning(block, gravity);
  const double shear = gravity * std::sin(block.slope) - turn * block.height / 2;
  const double normal = gravity * std::cos(block.slope) + turn * block.width / 2;
  if (shear <= mu * normal) return {0, turn};
  return sliding_and_toppling(block, gravity);
}

bool is_clear_of_boundaries(const InclinedBlock& block, double distance) {
  const InclineMotion here = initial_motion(block, 1);
  const auto moves_alike = [&](double slope, double friction) {
    InclinedBlock near = block;
    near.slope += slope;
    near.friction += friction;
    const InclineMotion there = initial_motion(near, 1);
    return there.slides() == here.slides() && there.topples() == here.topples();
  };
  return moves_alike(distance, 0) && moves_alike(-distance, 0) && moves_alike(0, distance) && moves_alike(0, -distance);
}

}  // namespace exact
