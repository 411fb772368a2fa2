#include "engine/simulation/block_values.h"

#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "engine/core/principal_stress.h"

namespace dda {
namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

std::span<const int> blocks_of(const Measurement& measurement) {
  if (measurement.blocks.empty()) return {&measurement.block, 1};
  return measurement.blocks;
}

Vec3 stress_of(const BlockSystem& system, const Measurement& measurement) {
  if (measurement.blocks.empty()) return system.state.stress[at(measurement.block)];
  Vec3 sum = Vec3::Zero();
  double area = 0;
  for (const int block : measurement.blocks) {
    sum += system.terms.area[at(block)] * system.state.stress[at(block)];
    area += system.terms.area[at(block)];
  }
  return sum / area;
}

// x, y and turn of the common centroid's motion.
Vec3 mean_motion(const Model& model, const std::vector<int>& blocks, const std::vector<Vec6>& values) {
  Vec3 sum = Vec3::Zero();
  double mass = 0;
  for (const int block : blocks) {
    sum += model.mass_of(block) * values[at(block)].head<3>();
    mass += model.mass_of(block);
  }
  return sum / mass;
}

Vec2 displacement_of(const BlockSystem& system, const Measurement& measurement) {
  if (!measurement.blocks.empty())
    return mean_motion(system.model, measurement.blocks, system.state.displacement).head<2>();
  return point_displacement(system.model, system.state, measurement.block, measurement.point);
}

Vec2 velocity_of(const BlockSystem& system, const Measurement& measurement) {
  if (!measurement.blocks.empty())
    return mean_motion(system.model, measurement.blocks, system.state.velocity).head<2>();
  return point_velocity(system.model, system.state, measurement.block, measurement.point);
}

Vec2 acceleration_of(const BlockSystem& system, const Measurement& measurement) {
  if (!measurement.blocks.empty())
    return mean_motion(system.model, measurement.blocks, system.state.acceleration).head<2>();
  const std::size_t i = at(measurement.block);
  const Vec2 offset = measurement.point - system.model.blocks[i].moments.centroid;
  return displacement_rows(system.state.deformation[i] * offset) * system.state.acceleration[i];
}

double rotation_of(const BlockSystem& system, const Measurement& measurement) {
  if (!measurement.blocks.empty()) return mean_motion(system.model, measurement.blocks, system.state.displacement)(2);
  return system.state.displacement[at(measurement.block)](2);
}

double kinetic_energy_of(const BlockSystem& system, const Measurement& measurement) {
  double energy = 0;
  for (const int block : blocks_of(measurement)) {
    const Vec6& velocity = system.state.velocity[at(block)];
    energy += velocity.dot(momentum(system.terms.inertia[at(block)], velocity)) / 2;
  }
  return energy;
}

}  // namespace

double block_value(const BlockSystem& system, const Measurement& measurement) {
  const auto stress = [&] { return stress_of(system, measurement); };
  switch (measurement.quantity) {
    case Quantity::stress_xx: return stress()(0);
    case Quantity::stress_yy: return stress()(1);
    case Quantity::stress_xy: return stress()(2);
    case Quantity::stress_1: return largest_principal(stress());
    case Quantity::stress_2: return smallest_principal(stress());
    case Quantity::stress_angle: return principal_angle(stress());
    case Quantity::mean_stress: return mean_stress(stress());
    case Quantity::max_shear: return largest_shear(stress());
    case Quantity::displacement_x: return displacement_of(system, measurement).x();
    case Quantity::displacement_y: return displacement_of(system, measurement).y();
    case Quantity::velocity_x: return velocity_of(system, measurement).x();
    case Quantity::velocity_y: return velocity_of(system, measurement).y();
    case Quantity::acceleration_x: return acceleration_of(system, measurement).x();
    case Quantity::acceleration_y: return acceleration_of(system, measurement).y();
    case Quantity::rotation: return rotation_of(system, measurement);
    case Quantity::kinetic_energy: return kinetic_energy_of(system, measurement);
    default: return std::nan("");  // no quantity of blocks
  }
}

}  // namespace dda
