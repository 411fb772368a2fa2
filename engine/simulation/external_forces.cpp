#include "engine/simulation/external_forces.h"

#include <cstddef>

#include "engine/simulation/support_set.h"
#include "engine/terms/gravity.h"
#include "engine/terms/load.h"

namespace dda {
namespace {

const TimeFunction always = Constant{};

// The load whose stretch lies between these offsets from the centroid of its block.
Vec6 force_of(const EdgeLoad& load, const Vec2& from, const Vec2& to) {
  if (!load.follows) return edge_load(from, to, load.traction, load.rise);
  const auto turned = [&](const Vec2& traction) { return turned_with_edge(load.to - load.from, to - from, traction); };
  return edge_load(from, to, turned(load.traction), turned(load.rise));
}

}  // namespace

ExternalForces::ExternalForces(const Model& model, const State& state, const WaveCorrections& waves) {
  loads_.reserve(model.point_loads.size() + model.edge_loads.size());
  point_loads_ = model.point_loads.size();
  for (const PointLoad& load : model.point_loads) loads_.push_back({load.block, Vec6::Zero(), &load.history});
  for (const EdgeLoad& load : model.edge_loads) loads_.push_back({load.block, Vec6::Zero(), &load.history});
  for (std::size_t i = 0; i < model.supports.size(); ++i) {
    if (!leaves_force(model.supports[i])) continue;
    loads_.push_back({model.supports[i].block, Vec6::Zero(), &always});
    reactions_.push_back({i, Vec2::Zero()});
  }
  update_geometry(model, state);
  correct_levers(model, waves);
  weigh(model, {});
  begin_stage(model, 0);
}

bool ExternalForces::begin_stage(const Model& model, std::size_t stage) {
  bool is_other = false;
  std::size_t next = 0;
  const auto put = [&](const StageSpan& stages) {
    Load& load = loads_[next++];
    is_other = is_other || load.in_force != stages.has(stage);
    load.in_force = stages.has(stage);
  };
  for (const PointLoad& load : model.point_loads) put(load.stages);
  for (const EdgeLoad& load : model.edge_loads) put(load.stages);
  return is_other;
}

void ExternalForces::weigh(const Model& model, const std::vector<bool>& absent) {
  if (model.gravity.isZero()) return;
  weight_.setZero(static_cast<Eigen::Index>(6 * model.blocks.size()));
  for (std::size_t i = 0; i < model.blocks.size(); ++i)
    weight_.segment<2>(static_cast<Eigen::Index>(6 * i)) =
        dda::weight(model.mass_of(static_cast<int>(i)), model.gravity);
  for (const HeldBlock& held : model.held_blocks) weight_.segment<6>(6 * held.block).setZero();
  for (std::size_t i = 0; i < absent.size(); ++i)
    if (absent[i]) weight_.segment<6>(static_cast<Eigen::Index>(6 * i)).setZero();
}

void ExternalForces::update_geometry(const Model& model, const State& state) {
  const auto offset = [&](int block, const Vec2& point) -> Vec2 {
    return local_position(model, state, block, point) - local_centroid(model, state, block);
  };
  std::size_t next = 0;
  for (const PointLoad& load : model.point_loads)
    loads_[next++].force = point_load(offset(load.block, load.point), load.force);
  for (const EdgeLoad& load : model.edge_loads)
    loads_[next++].force = force_of(load, offset(load.block, load.from), offset(load.block, load.to));
  for (const Reaction& reaction : reactions_) {
    const PointSupport& support = model.supports[reaction.support];
    loads_[next++].force = point_load(offset(support.block, support.point), reaction.force);
  }
}

void ExternalForces::correct_levers(const Model& model, const WaveCorrections& waves) {
  const auto centroid = [&](int block) { return model.blocks[static_cast<std::size_t>(block)].moments.centroid; };
  std::size_t next = 0;
  for (const PointLoad& load : model.point_loads)
    loads_[next++].force += waves.lever_correction(load.block, load.point - centroid(load.block), load.force);
  for (const EdgeLoad& load : model.edge_loads)
    loads_[next++].force += waves.lever_correction(load.block, (load.from + load.to) / 2 - centroid(load.block),
                                                   (load.to - load.from).norm() * load.traction);
}

void ExternalForces::keep_reaction(std::size_t support, const Vec2& offset, const Vec2& force) {
  const std::size_t others = loads_.size() - reactions_.size();
  for (std::size_t i = 0; i < reactions_.size(); ++i) {
    if (reactions_[i].support != support) continue;
    reactions_[i].force = force;
    loads_[others + i].force = point_load(offset, force);
  }
}

Vec2 ExternalForces::reaction(std::size_t support) const {
  for (const Reaction& reaction : reactions_)
    if (reaction.support == support) return reaction.force;
  return Vec2::Zero();
}

void ExternalForces::leave_out(const Model& model, const std::vector<bool>& absent) {
  for (Load& load : loads_) load.acts = !absent[static_cast<std::size_t>(load.block)];
  weigh(model, absent);
}

void ExternalForces::filter(const WaveCorrections& waves) {
  for (std::size_t i = 0; i < loads_.size(); ++i) {
    const bool on_face = i >= point_loads_ && i < loads_.size() - reactions_.size();
    loads_[i].filter = on_face ? waves.face_load_filter(loads_[i].block) : waves.load_filter(loads_[i].block);
  }
}

void ExternalForces::loads_at(double time, Eigen::VectorXd& force) const {
  force.setZero();
  for (const Load& load : loads_) {
    if (!load.acts || !load.in_force) continue;
    const auto history = [&](double t) { return evaluate(*load.history, t); };
    force.segment<6>(6 * load.block) += load.filter(history, time) * load.force;
  }
}

void ExternalForces::add_edge_loads(const std::vector<bool>& chosen, double time, Eigen::VectorXd& force) const {
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    if (!chosen[i]) continue;
    const Load& load = loads_[point_loads_ + i];
    force.segment<6>(6 * load.block) += evaluate(*load.history, time) * load.force;
  }
}

}  // namespace dda
