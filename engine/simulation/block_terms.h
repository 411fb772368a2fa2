// What the terms say of each block, ready for assembly: inertia, area and elasticity.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "engine/core/types.h"
#include "engine/model/model.h"
#include "engine/model/state.h"
#include "engine/terms/inertia.h"

namespace dda {

struct BlockTerms {
  std::vector<Inertia> inertia;
  std::vector<double> area;      // m2
  std::vector<Mat3> elasticity;  // Pa
  std::vector<Mat3> compliance;  // 1/Pa

  // Rotation (rad) at which each block has the directions in which its strains, their rates, its stress and its inertia
  // are measured.
  std::vector<double> directions;
  std::vector<Vec3> centrifugal;  // N m per m of thickness, on the strains

  // What finite kinematics change.
  template <typename Self, typename Archive>
  static void visit(Self& self, Archive& archive) {
    auto& [inertia, area, elasticity, compliance, directions, centrifugal] = self;
    for (auto& each : inertia) archive(each.squares, each.beyond);
    archive.each(area);
    archive.each(directions);
    archive.each(centrifugal);
  }
};

// Held blocks have no mass here: their motion does not follow from forces.
BlockTerms make_block_terms(const Model& model);

// Elasticity and compliance by the materials that the model has now, and masses, of which absent blocks have none:
// `absent` says so of each block, and is empty where none is.
void set_elasticity(const Model& model, BlockTerms& terms);
void set_masses(const Model& model, const std::vector<bool>& absent, BlockTerms& terms);

// The same with the factor on the inertia of the strains that the stage asks for.
BlockTerms make_block_terms(const Model& model, const Stage& stage);
void set_strain_inertia(const Stage& stage, BlockTerms& terms);

// Area (m2) and mean squares (m2) of a deformed block (finite kinematics).
double deformed_area(const Model& model, const State& state, std::size_t block);
Vec3 deformed_squares(const Model& model, const State& state, std::size_t block);

// Damping matrices of the blocks that have an absorbing edge, at most one entry a block; of the edges that act in
// `stage`.
using BlockDamping = std::vector<std::pair<int, Mat6>>;
BlockDamping make_block_damping(const Model& model, const State& state, std::size_t stage);
void update_geometry(const Model& model, const State& state, std::size_t stage, BlockDamping& damping);

}  // namespace dda
