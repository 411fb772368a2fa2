#include "engine/simulation/block_terms.h"

#include <Eigen/LU>
#include <algorithm>
#include <cstddef>

#include "engine/terms/viscous_boundary.h"

namespace dda {
namespace {

BlockDamping::iterator find_block(int block, BlockDamping& damping) {
  return std::find_if(damping.begin(), damping.end(), [&](const auto& entry) { return entry.first == block; });
}

}  // namespace

BlockTerms make_block_terms(const Model& model) {
  BlockTerms terms;
  const std::size_t blocks = model.blocks.size();
  terms.inertia.reserve(blocks), terms.area.reserve(blocks), terms.directions.reserve(blocks);
  terms.centrifugal.reserve(blocks), terms.elasticity.reserve(blocks), terms.compliance.reserve(blocks);
  for (std::size_t i = 0; i < model.blocks.size(); ++i) {
    const Block& block = model.blocks[i];
    terms.inertia.push_back({model.mass_of(static_cast<int>(i)), mean_squares(block.moments), 1});
    terms.area.push_back(block.moments.area);
    terms.directions.push_back(0);
    terms.centrifugal.emplace_back(Vec3::Zero());
  }
  for (const HeldBlock& held : model.held_blocks) terms.inertia[static_cast<std::size_t>(held.block)].mass = 0;
  set_elasticity(model, terms);
  return terms;
}

void set_elasticity(const Model& model, BlockTerms& terms) {
  terms.elasticity.clear();
  terms.compliance.clear();
  for (std::size_t i = 0; i < model.blocks.size(); ++i) {
    terms.elasticity.push_back(elasticity_matrix(model.material_of(static_cast<int>(i))));
    terms.compliance.emplace_back(terms.elasticity.back().inverse());
  }
}

void set_masses(const Model& model, const std::vector<bool>& absent, BlockTerms& terms) {
  for (std::size_t i = 0; i < terms.inertia.size(); ++i)
    terms.inertia[i].mass = !absent.empty() && absent[i] ? 0 : model.mass_of(static_cast<int>(i));
  for (const HeldBlock& held : model.held_blocks) terms.inertia[static_cast<std::size_t>(held.block)].mass = 0;
}

BlockTerms make_block_terms(const Model& model, const Stage& stage) {
  BlockTerms terms = make_block_terms(model);
  set_strain_inertia(stage, terms);
  return terms;
}

void set_strain_inertia(const Stage& stage, BlockTerms& terms) {
  for (Inertia& inertia : terms.inertia) inertia.strain_inertia = stage.strain_inertia;
}

double deformed_area(const Model& model, const State& state, std::size_t block) {
  return model.blocks[block].moments.area * state.deformation[block].determinant();
}

Vec3 deformed_squares(const Model& model, const State& state, std::size_t block) {
  return deformed_mean_squares(mean_squares(model.blocks[block].moments), state.deformation[block]);
}

BlockDamping make_block_damping(const Model& model, const State& state, std::size_t stage) {
  BlockDamping damping;
  for (const ViscousEdge& edge : model.viscous_edges)
    if (find_block(edge.block, damping) == damping.end()) damping.emplace_back(edge.block, Mat6::Zero());
  update_geometry(model, state, stage, damping);
  return damping;
}

void update_geometry(const Model& model, const State& state, std::size_t stage, BlockDamping& damping) {
  for (auto& [block, matrix] : damping) matrix.setZero();
  for (const ViscousEdge& edge : model.viscous_edges) {
    if (static_cast<std::size_t>(edge.first_stage) > stage) continue;
    const Vec2 centroid = local_centroid(model, state, edge.block);
    find_block(edge.block, damping)->second += viscous_damping(
        local_position(model, state, edge.block, edge.from) - centroid,
        local_position(model, state, edge.block, edge.to) - centroid, edge.normal_impedance, edge.shear_impedance);
  }
}

}  // namespace dda
