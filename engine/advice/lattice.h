// A block that repeats itself in a row or over the plane: what waves see of a mesh. Its matrices are the engine's own,
// assembled for the block among its neighbours as for any scene.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/contact/contact_set.h"
#include "engine/geometry/polygon.h"
#include "engine/model/model.h"
#include "engine/waves/wave_corrections.h"

namespace dda {

// Equal blocks at ring + i offsets: a row where all offsets are parallel, else a mesh of the plane.
struct Lattice {
  Material material;
  Ring ring;
  std::vector<Vec2> offsets;          // to the neighbours that share an edge, in pairs of opposite ones
  std::vector<JointMaterial> joints;  // with each neighbour, with the law and springs that the scene uses
  Vec2 normal = Vec2::UnitX();        // of the interfaces, of a row along it
  bool row = false;
  bool assumed = false;  // no block of the scene is among copies of itself
  std::string origin;    // what it is taken from or assumed to be, for people

  // Unit normals of the interfaces, each pair of opposite ones once: to the right, or straight up.
  [[nodiscard]] std::vector<Vec2> face_normals() const;
};

// True when turning the lattice from one direction (unit vectors) to the other makes no difference.
bool looks_the_same(const Lattice& lattice, const Vec2& from, const Vec2& to);

// The largest block of the material whose neighbours are copies of it; where there is none, squares (in a row:
// rectangles) of the largest size across an interface. Nothing for a material whose blocks touch none of their own.
std::optional<Lattice> find_lattice(const Model& model, const ContactSet& contacts, int material);

// Blocks `factor` times as large; those of a row as high as before.
Lattice scaled(const Lattice& lattice, double factor);

// The same blocks held together by the consistent law.
Lattice with_consistent_joints(const Lattice& lattice);

// One neighbour's part in the equations of the block.
struct LatticeCoupling {
  Vec2 offset;
  Mat6 stiffness, inertia;              // force on the block by the neighbour's unknowns and their accelerations
  Vec2 normal;                          // of the interface, out of the block
  Vec2 middle;                          // of the interface, from the block's centroid
  double length = 0;                    // m
  Mat26 traction_here, traction_there;  // mean (normal, shear) traction, Pa, by the unknowns of block and neighbour
};

struct LatticeMatrices {
  Mat6 stiffness, inertia;  // of the block with its part of the interfaces
  std::vector<LatticeCoupling> couplings;
  WaveCorrections waves;  // of the block, its number 0, where neighbours may be left out

  // The unknowns' share of a force (N) on the block, and how its history is filtered, as a run has it.
  [[nodiscard]] Vec6 load(const Vec2& offset, const Vec2& force) const;
  [[nodiscard]] LoadFilter load_filter() const { return waves.face_load_filter(0); }
};

// By the stage's inertia options and dt. `present` leaves out neighbours where it is false; empty: all are there.
LatticeMatrices lattice_matrices(const Lattice& lattice, const Stage& stage, const std::vector<bool>& present = {});

}  // namespace dda
