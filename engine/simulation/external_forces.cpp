#include "dda/simulation/external_forces.h"

#include <cstddef>

#include "dda/terms/gravity.h"
#include "dda/terms/load.h"

namespace dda {

ExternalForces::ExternalForces(const Model& model, const State& state) {
  loads_.reserve(model.point_loads.size() + model.edge_loads.size());
  for (const PointLoad& load : model.point_loads) loads_.push_back({load.block, Vec6::Zero(), &load.history});
  for (const EdgeLoad& load : model.edge_loads) loads_.push_back({load.block, Vec6::Zero(), &load.history});
  update_geometry(model, state);
  if (model.gravity.isZero()) return;
  weight_.setZero(static_cast<Eigen::Index>(6 * model.blocks.size()));
  for (std::size_t i = 0; i < model.blocks.size(); ++i)
    weight_.segment<2>(static_cast<Eigen::Index>(6 * i)) =
        dda::weight(model.mass_of(static_cast<int>(i)), model.gravity);
}

void ExternalForces::update_geometry(const Model& model, const State& state) {
  const auto offset = [&](int block, const Vec2& point) -> Vec2 {
    return current_position(model, state, block, point) - current_centroid(model, state, block);
  };
  std::size_t next = 0;
  for (const PointLoad& load : model.point_loads)
    loads_[next++].force = point_load(offset(load.block, load.point), load.force);
  for (const EdgeLoad& load : model.edge_loads)
    loads_[next++].force = edge_load(offset(load.block, load.from), offset(load.block, load.to), load.traction);
}

void ExternalForces::loads_at(double time, Eigen::VectorXd& force) const {
  force.setZero();
  for (const Load& load : loads_) force.segment<6>(6 * load.block) += evaluate(*load.history, time) * load.force;
}

}  // namespace dda
