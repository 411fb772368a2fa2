#include "engine/model/state.h"

#include <cstddef>

namespace dda {
namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

}  // namespace

State initial_state(const Model& model) {
  State state;
  const std::size_t n = model.blocks.size();
  state.displacement.assign(n, Vec6::Zero());
  state.velocity.assign(n, Vec6::Zero());
  state.acceleration.assign(n, Vec6::Zero());
  state.stress.reserve(n);
  state.deformation.assign(n, Mat2::Identity());
  for (std::size_t i = 0; i < n; ++i) {
    const Block& block = model.blocks[i];
    state.velocity[i].head<2>() = block.initial_velocity;
    state.velocity[i](2) = block.initial_spin;
    state.velocity[i].tail<3>() = block.initial_strain_rate;
    state.stress.push_back(block.initial_stress);
  }
  return state;
}

Vec2 local_centroid(const Model& model, const State& state, int block) {
  return local_place(model, model.blocks[at(block)].moments.centroid) + state.displacement[at(block)].head<2>();
}

Vec2 local_position(const Model& model, const State& state, int block, const Vec2& reference) {
  return local_place(model, reference) + point_displacement(model, state, block, reference);
}

Vec2 current_centroid(const Model& model, const State& state, int block) {
  return model.blocks[at(block)].moments.centroid + state.displacement[at(block)].head<2>();
}

Vec2 point_displacement(const Model& model, const State& state, int block, const Vec2& reference) {
  const Vec2 offset = reference - model.blocks[at(block)].moments.centroid;
  return state.displacement[at(block)].head<2>() + (state.deformation[at(block)] - Mat2::Identity()) * offset;
}

Vec2 current_position(const Model& model, const State& state, int block, const Vec2& reference) {
  return reference + point_displacement(model, state, block, reference);
}

Vec2 point_velocity(const Model& model, const State& state, int block, const Vec2& reference) {
  const Vec2 offset = reference - model.blocks[at(block)].moments.centroid;
  return displacement_rows(state.deformation[at(block)] * offset) * state.velocity[at(block)];
}

}  // namespace dda
