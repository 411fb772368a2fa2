#include "engine/advice/joints_in_waves.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <variant>

#include "engine/advice/acting_place.h"
#include "engine/advice/reach.h"
#include "engine/contact/joint_stiffness.h"
#include "engine/contact/make_element.h"
#include "engine/geometry/polygon.h"
#include "engine/model/rock_change.h"

namespace dda {
namespace {

constexpr double tolerance = 1e-6;     // of lengths
constexpr double hardly_damps = 1e-3;  // of the wave's amplitude, that dashpots of joints take
constexpr double slack = 1e-3;         // of the wave's largest stress: a joint that lacks less hardly opens

// Tension over shear at an end of a joint of springs: blocks in S waves turn, press on a neighbour at one end of a face
// and pull at the other. Meshes of squares tear, by runs, below 0.2 to 0.8 of the shear (of three), those of bricks,
// whose faces have two neighbours, below 1 to 1.5 (of three).
constexpr double tension_by_turning = 1, tension_by_turning_bricks = 1.5;

Mat2 tensor_of(const Vec3& stress) {
  Mat2 tensor;
  tensor << stress[0], stress[2], stress[2], stress[1];
  return tensor;
}

// Pa, that weight can press a joint with, where the stress that blocks begin with does not have it.
double weight_above(const Model& model) {
  const bool all_begin_with_stress =
      std::ranges::none_of(model.blocks, [](const Block& block) { return block.initial_stress.isZero(0); });
  if (model.gravity.isZero(0) || all_begin_with_stress) return 0;
  double density = 0;
  for (const Material& material : model.materials) density = std::max(density, material.density);
  const Vec2 down = model.gravity.normalized();
  return density * model.gravity.norm() * reach_of(model, down).length();
}

// Pa, by which a load differs from what the block's stress at the start has there: what is in situ brings nothing.
double brought_by(const Model& model, const EdgeLoad& load) {
  return (load.traction - traction_at_start(model, load)).norm() + load.rise.norm();
}

// Pa, that weight and constant loads of static stages before can press a joint with.
double most_pressure(const Model& model, std::size_t stage) {
  const double weight = weight_above(model);
  const auto first = model.stages.begin();
  if (std::none_of(first, first + static_cast<std::ptrdiff_t>(stage),
                   [](const Stage& each) { return each.integrator.is_static; }))
    return weight;
  double most = 0;
  for (const EdgeLoad& load : model.edge_loads)
    if (std::holds_alternative<Constant>(load.history)) most = std::max(most, brought_by(model, load));
  return weight + most;
}

// Stress of a wave of 1 Pa.
Mat2 unit_stress(const Material& material, const WaveStress& wave) {
  const Vec2& along = wave.direction;
  const Vec2 across(-along.y(), along.x());
  if (wave.kind == WaveKind::s) return along * across.transpose() + across * along.transpose();
  const double nu = material.poisson;
  double sideways = 0;
  if (wave.kind == WaveKind::p) sideways = material.plane == PlaneState::strain ? nu / (1 - nu) : nu;
  return along * along.transpose() + sideways * across * across.transpose();
}

class Joint {
 public:
  Joint(const Model& model, const Interface& interface, const JointMaterial& joint, bool springs)
      : normal_(interface.normal),
        tangent_(-normal_.y(), normal_.x()),
        joint_(joint),
        turning_(springs ? tension_by_turning : 0) {
    int longer = 0;  // faces than the joint
    for (const int index : {interface.block_a, interface.block_b}) {
      const Block& block = model.blocks[static_cast<std::size_t>(index)];
      if (extent_along(block.shape.outer, tangent_) > (1 + tolerance) * interface.length) ++longer;
      start_ += tensor_of(block.initial_stress) / 2;
    }
    if (springs && longer == 2) turning_ = tension_by_turning_bricks;
  }

  // `pressure` may be there besides.
  [[nodiscard]] bool opens(const Mat2& wave, double pressure, double least) const {
    const double turning = turning_ * std::abs(normal_.dot(wave * tangent_));
    return tension(wave) + turning - pressure > strength() + least;
  }
  [[nodiscard]] bool slides(const Mat2& wave, double pressure, double least) const {
    const double pressed = pressure - tension(wave);  // less than nothing takes off the cohesion
    const double shear = std::abs(normal_.dot((start_ + wave) * tangent_));
    return shear > joint_.cohesion + std::tan(joint_.friction_angle) * pressed + least;
  }

 private:
  [[nodiscard]] double tension(const Mat2& wave) const { return normal_.dot((start_ + wave) * normal_); }
  [[nodiscard]] double strength() const {
    const double friction = std::tan(joint_.friction_angle);
    return friction > 0 ? std::min(joint_.tensile_strength, joint_.cohesion / friction) : joint_.tensile_strength;
  }

  Vec2 normal_, tangent_;
  const JointMaterial& joint_;
  double turning_;
  Mat2 start_ = Mat2::Zero();
};

bool has_bond(const JointMaterial& joint) { return joint.cohesion > 0 || joint.tensile_strength > 0; }

// Share of a wave's amplitude that the dashpots C of a joint across its way take, two of them beside springs k: as gaps
// of F/(2 k) open and close they take 2 C (omega F/(2 k))^2/2 of the power F^2/(2 Z) that runs through impedance Z.
double taken_by_dashpots(const Model& model, std::size_t stage, const Interface& interface, const WaveStress& wave) {
  const JointMaterial& joint = joints_in(model, stage)[static_cast<std::size_t>(interface.joint)];
  const bool springs = is_springs(joint, model.stages[stage].kinematics);
  const bool acts = is_dry(joint) && (springs || joint.law == InterfaceLaw::projected);
  if (joint.contact_damping == 0 || !acts) return 0;
  const InterfaceElement element =
      make_element(model, interface, springs ? InterfaceLaw::classical : InterfaceLaw::projected);
  const Material& rock = model.material_of(interface.block_a);
  const double omega = 2 * std::numbers::pi * wave.frequency;
  const double impedance = rock.density * continuum_speed(rock, wave.kind) * interface.length;
  const Eigen::Index row = wave.kind == WaveKind::s ? 1 : 0;
  const double across = std::pow(interface.normal.dot(wave.direction), 2);
  return across * element.dashpot(row) * std::pow(omega / element.stiffness(row), 2) * impedance / 4;
}

template <typename Load>
bool is_of(const Load& load, const SceneLoad& wanted) {
  return load.block == wanted.block && !std::holds_alternative<Constant>(load.history);
}

}  // namespace

double unit_of_load(const Model& model, const SceneLoad& load, WaveKind kind, const Vec2& direction, bool row) {
  const Vec2 particles = polarization(kind, direction);
  if (!row) return load.motion.dot(particles);
  double force = 0;
  for (const EdgeLoad& each : model.edge_loads)
    if (is_of(each, load)) force += (each.to - each.from).norm() * each.traction.dot(particles);
  for (const PointLoad& each : model.point_loads)
    if (is_of(each, load)) force += each.force.dot(particles);
  const Block& block = model.blocks[static_cast<std::size_t>(load.block)];
  return force * extent_along(block.shape.outer, direction) / block.moments.area;
}

// What pushes along the way is pressure.
WaveStress stress_of(const SceneLoad& load, const HistoryErrors& history, const WaveWay& wave, double run) {
  constexpr int samples = 2000;
  double low = std::min(0.0, history.arrival.lowest), high = std::max(0.0, history.arrival.highest);
  for (int i = 0; i <= samples; ++i) {
    const double value = load.history.value(i * load.history.run / samples);
    low = std::min(low, value);
    high = std::max(high, value);
  }
  const double there_and_back = std::max(history.place, (history.place + run) / 2);
  return {wave.kind,
          wave.direction,
          std::min(-wave.unit * low, -wave.unit * high),
          std::max(-wave.unit * low, -wave.unit * high),
          load.place,
          there_and_back,
          1 / load.history.period};
}

std::string why_joints_give_way(const Model& model, std::size_t stage, const ContactSet& drawn,
                                const WaveStress& wave) {
  const bool unlimited = model.stages[stage].unlimited_strength;
  const auto& joints = joints_in(model, stage);
  const double pressure = most_pressure(model, stage);
  const double least = slack * std::max(std::abs(wave.least), std::abs(wave.most));
  const double width = reach_of(model, left_of(wave.direction)).length();
  double taken = 0;
  for (const Interface& interface : drawn.interfaces) {
    const JointMaterial& material = joints[static_cast<std::size_t>(interface.joint)];
    if (interface.length == 0 || material.bonded) continue;
    const double gone = std::abs(wave.direction.dot((interface.from + interface.to) / 2 - wave.from));
    if (gone > wave.distance + interface.length) continue;
    const Joint joint(model, interface, material, is_springs(material, model.stages[stage].kinematics));
    const Mat2 unit = unit_stress(model.material_of(interface.block_a), wave);
    for (const double stress : {wave.least, wave.most}) {
      if (!(unlimited && has_bond(material)) && joint.opens(stress * unit, pressure, least))
        return fmt::format("its stress of {:.3g} MPa opens joints \"{}\"", std::abs(stress) / 1e6, material.name);
      if (!unlimited && joint.slides(stress * unit, pressure, least))
        return fmt::format("its stress of {:.3g} MPa makes joints \"{}\" slide", std::abs(stress) / 1e6, material.name);
    }
    taken += taken_by_dashpots(model, stage, interface, wave) * interface.length / width;
    if (taken > hardly_damps) return fmt::format("contact_damping of joints \"{}\" takes from it", material.name);
  }
  return "";
}

}  // namespace dda
