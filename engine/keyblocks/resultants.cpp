#include "engine/keyblocks/resultants.h"

#include <fmt/format.h>

#include <cstddef>
#include <variant>

#include "engine/geometry/segment.h"

namespace dda {
namespace {

bool is_constant(const TimeFunction& history) { return std::holds_alternative<Constant>(history); }

class Forces {
 public:
  Forces(const std::vector<RockBody>& bodies, std::size_t blocks) : bodies_(bodies), body_of_(blocks, -1) {
    result_.of.resize(bodies.size());
    for (std::size_t body = 0; body < bodies.size(); ++body) {
      for (const int block : bodies[body].blocks) body_of_[static_cast<std::size_t>(block)] = static_cast<int>(body);
    }
  }

  void add_body_force(const Vec2& acceleration) {
    for (std::size_t i = 0; i < bodies_.size(); ++i) result_.of[i].force += bodies_[i].mass * acceleration;
  }

  // Blocks that are taken out are in no body.
  void add(int block, const Vec2& place, const Vec2& force) {
    const int body = body_of_[static_cast<std::size_t>(block)];
    if (body < 0) return;
    Resultant& acting = result_.of[static_cast<std::size_t>(body)];
    acting.force += force;
    acting.moment += cross(place - bodies_[static_cast<std::size_t>(body)].centroid, force);
  }

  void leave_out(std::string what) { result_.left_out.push_back(std::move(what)); }

  Resultants result() { return std::move(result_); }

 private:
  const std::vector<RockBody>& bodies_;
  std::vector<int> body_of_;  // -1: taken out
  Resultants result_;
};

void add_loads(const Model& model, Forces& forces) {
  std::size_t changing = 0;
  for (const PointLoad& load : model.point_loads) {
    if (is_constant(load.history) && load.stages.is_whole_run())
      forces.add(load.block, load.point, load.force);
    else
      ++changing;
  }
  for (const EdgeLoad& load : model.edge_loads) {
    if (is_constant(load.history) && load.stages.is_whole_run())
      forces.add(load.block, (load.from + load.to) / 2, (load.to - load.from).norm() * load.traction);
    else
      ++changing;
  }
  if (changing > 0) forces.leave_out(fmt::format("{} loads that change with time or by stage", changing));
}

// A bolt in tension pulls its two ends together.
void add_pretension(const Model& model, Forces& forces) {
  for (const Bolt& bolt : model.bolts) {
    for (const BoltLink& link : bolt.links) {
      forces.add(link.block_a, link.point_a, bolt.pretension * bolt.direction);
      forces.add(link.block_b, link.point_b, -bolt.pretension * bolt.direction);
    }
  }
}

}  // namespace

Resultants resultants_on(const std::vector<RockBody>& bodies, const Model& model, const Vec2& acceleration) {
  Forces forces(bodies, model.blocks.size());
  forces.add_body_force(model.gravity + acceleration);
  add_loads(model, forces);
  add_pretension(model, forces);
  return forces.result();
}

}  // namespace dda
