#include "engine/advice/chain.h"

#include <Eigen/LU>
#include <cmath>
#include <cstddef>
#include <variant>

#include "engine/contact/joint_stiffness.h"
#include "engine/contact/make_contacts.h"
#include "engine/simulation/support_set.h"
#include "engine/terms/load.h"

namespace dda {
namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

// The scene with joints that stay closed, and of supports those that act on the way.
Model prepared(const Model& model, const ChainPath& path, const Stage& stage, bool consistent) {
  Model result = model;
  const JointMaterial standard;
  for (JointMaterial& joint : result.joints) {
    if (consistent) {
      joint.law = InterfaceLaw::consistent;
      joint.penalty = standard.penalty;
      joint.stabilisation = standard.stabilisation;
    } else if (is_springs_where_blocks_move(joint) && stage.kinematics == Kinematics::finite) {
      joint.law = InterfaceLaw::classical;
    }
  }
  result.supports.clear();
  for (const std::size_t index : path.supports) result.supports.push_back(model.supports[index]);
  return result;
}

// The force of a joint on one of its blocks, along the wave's motion.
class JointForce {
 public:
  JointForce(const Model& model, const ContactSet& contacts, std::size_t index, int on, const Vec2& particles)
      : model_(model), interface_(contacts.interfaces[index]), element_(contacts.elements.own()[index]) {
    const Vec2& normal = interface_.normal;  // from block a to block b
    const double sign = on == interface_.block_a ? 1 : -1;
    weights_ = sign * interface_.length * Vec2(particles.dot(normal), particles.dot(Vec2(-normal.y(), normal.x())));
  }

  // N, where one of the two blocks alone has moved.
  [[nodiscard]] double by(int block, const Vec6& moved) const {
    const Vec6 none = Vec6::Zero();
    const Vec6& a = block == interface_.block_a ? moved : none;
    const Vec6& b = block == interface_.block_a ? none : moved;
    return weights_.dot(mean_traction(
        model_, interface_, element_,
        linear_state(element_, Vec4::Zero(), a, b, stress(interface_.block_a, a), stress(interface_.block_b, b))));
  }

 private:
  [[nodiscard]] Vec3 stress(int block, const Vec6& moved) const {
    return elasticity_matrix(model_.material_of(block)) * moved.tail<3>();
  }

  const Model& model_;
  const Interface& interface_;
  const InterfaceElement& element_;
  Vec2 weights_;
};

}  // namespace

Chain::Chain(const Model& model, const ChainPath& path, const Stage& stage, bool consistent)
    : path_(path), particles_(polarization(path.kind, path.direction)) {
  const Model scene = prepared(model, path, stage, consistent);
  const ContactSet contacts = make_contacts(scene);
  const std::vector<SupportElement> supports = make_supports(scene, initial_state(scene));
  const WaveCorrections waves(scene, stage, contacts);
  fold({scene, make_block_terms(scene, stage), contacts, supports, waves});
  set_drive(scene, waves, supports);
  set_tractions(scene, contacts);
}

void Chain::fold(const LinearOperators& operators) {
  for (std::size_t number = 0; number < path_.layers.size(); ++number) {
    const ChainLayer& layer = path_.layers[number];
    Layer stiffness, inertia;
    const auto add = [&](int block, Mat6 Layer::*where) {
      stiffness.*where += operators.stiffness.block(layer.block, block);
      inertia.*where += operators.inertia.block(layer.block, block);
    };
    add(layer.block, &Layer::own);
    for (const ChainNeighbour& neighbour : layer.neighbours) {
      const int way = neighbour.layer - static_cast<int>(number);
      add(neighbour.block, way == 0 ? &Layer::own : (way > 0 ? &Layer::next : &Layer::last));
    }
    stiffness_.push_back(stiffness);
    inertia_.push_back(inertia);
  }
}

void Chain::set_drive(const Model& model, const WaveCorrections& waves, const std::vector<SupportElement>& supports) {
  const ChainLayer& first = path_.layers.front();
  load_filter_ = waves.face_load_filter(first.block);
  if (path_.driven_as_whole) {
    push_.head<2>() = particles_;
    unit_ = path_.layers[1].impedance;
    return;
  }
  const Vec2& centroid = model.blocks[at(first.block)].moments.centroid;
  double total = 0;
  const auto push = [&](const Vec2& point, const Vec2& force) {
    push_ += point_load(point - centroid, force) + waves.lever_correction(first.block, point - centroid, force);
    total += particles_.dot(force);
  };
  for (const EdgeLoad& load : model.edge_loads)
    if (load.block == first.block && !std::holds_alternative<Constant>(load.history))
      push((load.from + load.to) / 2, (load.to - load.from).norm() * load.traction);
  for (const PointLoad& load : model.point_loads)
    if (load.block == first.block && !std::holds_alternative<Constant>(load.history)) push(load.point, load.force);
  if (total != 0) {
    push_ /= total;
    return;
  }
  unit_ = first.impedance;
  for (std::size_t i = 0; i < supports.size(); ++i)
    if (supports[i].block == first.block && !is_still(model.supports[i]))
      push_ += supports[i].rows.transpose() * (supports[i].stiffness * particles_);
}

void Chain::set_tractions(const Model& model, const ContactSet& contacts) {
  tractions_.resize(path_.layers.size());
  for (std::size_t number = 1; number < path_.layers.size(); ++number) {
    const ChainLayer& layer = path_.layers[number];
    for (const ChainNeighbour& neighbour : layer.neighbours) {
      if (neighbour.layer != static_cast<int>(number) - 1) continue;
      const JointForce force(model, contacts, neighbour.interface, layer.block, particles_);
      for (int i = 0; i < 6; ++i) {
        tractions_[number].here[i] += force.by(layer.block, Vec6::Unit(i));
        tractions_[number].last[i] += force.by(neighbour.block, Vec6::Unit(i));
      }
    }
  }
}

// Behind the last layer that is looked at the next one follows it as the rock would; behind the last of all there is
// an end that swallows.
ComplexMat6 Chain::own_at_end(Complex square, int number) const {
  const ChainLayer& layer = path_.layers[at(number)];
  const Complex s = std::sqrt(square);  // its real part is not negative
  const ComplexMat6 own =
      stiffness_[at(number)].own.cast<Complex>() + square * inertia_[at(number)].own.cast<Complex>();
  if (number + 1 < static_cast<int>(path_.layers.size())) {
    const Complex late = std::exp(-s * layer.thickness / layer.speed);
    return own +
           late * (stiffness_[at(number)].next.cast<Complex>() + square * inertia_[at(number)].next.cast<Complex>());
  }
  const Vec6 rows = displacement_rows(layer.thickness / 2 * path_.direction).transpose() * particles_;
  return own + s * layer.impedance * (rows * rows.transpose()).cast<Complex>();
}

Complex Chain::force(Complex square, int joint, int layers) const {
  const auto forces = [&](std::size_t number, Mat6 Layer::*which) -> ComplexMat6 {
    return (stiffness_[number].*which).cast<Complex>() + square * (inertia_[number].*which).cast<Complex>();
  };
  const int first = path_.driven_as_whole ? 1 : 0;
  std::vector<ComplexMat6> step(at(joint) + 1);  // x_j = step_j x_(j-1)
  ComplexMat6 own = own_at_end(square, layers - 1);
  for (int number = layers - 1; number > first; --number) {
    const ComplexMat6 follows = -own.partialPivLu().solve(forces(at(number), &Layer::last));
    if (number <= joint) step[at(number)] = follows;
    own = forces(at(number) - 1, &Layer::own) + forces(at(number) - 1, &Layer::next) * follows;
  }
  ComplexVec6 last = push_.cast<Complex>();
  if (first == 0) {
    last = own.partialPivLu().solve(last);
  } else {
    last = -own.partialPivLu().solve(forces(1, &Layer::last) * last);
  }
  for (int number = first + 1; number < joint; ++number) last = step[at(number)] * last;
  const ComplexVec6 here = step[at(joint)] * last;
  const Traction& traction = tractions_[at(joint)];
  return (traction.here.cast<Complex>().dot(here) + traction.last.cast<Complex>().dot(last)) / unit_;
}

Complex exact_force(const ChainPath& path, Complex s, int joint, int layers) {
  const int first = path.driven_as_whole ? 1 : 0;
  const double end = path.layers[at(layers - 1)].impedance;
  std::vector<Complex> impedance(at(layers) + 1, end);  // that the wave sees at the first face of a layer
  std::vector<Complex> passed(at(layers), 1);           // velocity at its last face over that at its first
  for (int number = layers - 1; number >= first; --number) {
    const ChainLayer& layer = path.layers[at(number)];
    const Complex turn = std::tanh(s * layer.thickness / layer.speed);
    const Complex behind = impedance[at(number) + 1];
    impedance[at(number)] = layer.impedance * (behind + layer.impedance * turn) / (layer.impedance + behind * turn);
    passed[at(number)] = 1.0 / (std::cosh(s * layer.thickness / layer.speed) * (1.0 + behind / layer.impedance * turn));
  }
  Complex velocity = path.is_moved ? s / path.layers[at(first)].impedance : 1.0 / impedance[at(first)];
  for (int number = first; number < joint; ++number) velocity *= passed[at(number)];
  return impedance[at(joint)] * velocity;
}

}  // namespace dda
